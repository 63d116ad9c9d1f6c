#version 3.5;
global_settings { max_trace_level 6 photons { spacing .05 autostop 0 jitter 0 } }
light_source { <3,6,-3> rgb 1 photons { reflection on refraction on } }
sphere { <0,1,0>,.8 pigment { rgbf <1,1,1,.95> } finish { reflection .1 specular .5 } interior { ior 1.5 caustics 0 } photons { target 1.0 refraction on reflection off collect off } }
box { <-3,-.1,-3>,<3,0,3> pigment { rgb <.8,.8,.7> } photons { collect on pass_through } }
camera { location <0,3,-5> look_at .4*y }
