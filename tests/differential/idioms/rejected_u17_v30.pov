#version 3.0
global_settings { assumed_gamma 2.2 max_trace_level 6 ambient_light rgb 1 }
#include "colors.inc"
#include "textures.inc"
camera { location <0,1,-5> look_at 0 angle 40 }
light_source { <4,5,-5> color White fade_distance 10 fade_power 2 atmospheric_attenuation on }
#declare i = 0
#while (i < 5)
 sphere { <i-2,0,0>, 0.4 pigment { color rgb <i/5, 0.5, 1-i/5> } finish { reflection 0.2 specular 0.5 ambient 0.2 } }
 #declare i=i+1
#end
#declare T1 = texture { pigment { wood color_map { [0.0 rgb <.5,.3,.1>] [1.0 rgb <.8,.6,.3>] } turbulence <.1,.04,1> } }
box { <-3,-1,-1>, <3,-.5,1> texture { T1 rotate y*90 } }
sphere { <0,1,0>, .5 texture { pigment { rgbf <.9,.9,1,.9> } finish { refraction 1 ior 1.4 caustics .5 reflection .1 } } }
light_source { <0,3,0> color rgb .3 spotlight radius 20 falloff 30 tightness 5 point_at 0 looks_like { sphere { 0, .1 pigment { White } finish { ambient 1 } } } }
atmosphere { type 1 samples 10 distance 40 scattering 0.2 }
