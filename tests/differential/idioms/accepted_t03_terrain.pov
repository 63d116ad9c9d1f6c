#version 3.6;
global_settings { assumed_gamma 2.2 noise_generator 2 }
#declare Rough = function { pattern { granite turbulence .3 scale .6 } }
height_field { function 60, 60 { Rough(x,0,y)*.6 } smooth
  texture { pigment { slope y color_map { [0 rgb <.4,.35,.3>] [.6 rgb <.5,.45,.4>] [.8 rgb <.3,.5,.2>] [1 rgb <.35,.6,.25>] } } }
  translate <-.5,0,-.5> scale <8,2,8> }
plane { y, .35 texture { pigment { rgbf <.6,.8,.9,.6> } finish { reflection { .1,.6 fresnel } conserve_energy } normal { ripples .1 scale .3 } } interior { ior 1.33 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9,.9,1>] [.5 rgb <.3,.5,.9>] } } pigment { bozo turbulence .7 scale .2 color_map { [0 rgbt <1,1,1,.3>] [.6 rgbt 1] } } }
fog { fog_type 2 distance 20 color rgbt <.8,.85,1,.2> fog_offset .2 fog_alt .4 turbulence .2 up y }
light_source { <100,120,-80> rgb <1.2,1.1,.9> }
camera { location <0,2.2,-6> look_at <0,.4,0> angle 50 }
