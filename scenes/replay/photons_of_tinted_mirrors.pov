// Photons of a tinted mirror: adc_bailout asks for what fresnel reflects before metallic tints it, as of rays.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 photons { spacing 0.03 adc_bailout 0.035 max_trace_level 5 } }
camera { location <0, 6, -5> look_at 0 angle 50 }
light_source { <0, 5, -3> rgb 0.7 photons { reflection on } }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.7 } }
box { <-1, -1, 1>, <1, 1, 1.2> pigment { rgb 0.5 } finish { ambient 0 diffuse 0 reflection { 0.3, 0.31 fresnel metallic } }
  photons { target reflection on } }
