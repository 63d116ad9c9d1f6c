#version 3.1;
global_settings { assumed_gamma 2.2 }
#declare T1 = texture { pigment { agate agate_turb 0.7 color_map { [0 rgb 1][0.5 rgbf <.6,.3,.1,.2>][1 rgb <.2,.1,0>] } } finish { specular .5 roughness .05 } }
#declare T2 = texture { pigment { rgbt <1,1,1,.8> } } texture { pigment { spotted color_map { [0 rgbt 1] [.6 rgbt 1] [.61 rgb <1,0,0>] } scale .2 } }
#declare I1 = interior { ior 1.33 fade_power 1 fade_distance 3 }
#declare M1 = material { texture { T2 } interior { I1 } }
#macro Ring(n, r, Obj) #local i = 0; #while (i < n) object { Obj translate r*x rotate i*360/n*y } #local i = i+1; #end #end
#declare Bit = cone { 0, .4, .8*y, .1 }
union { Ring(8, 2.2, Bit) texture { T1 } }
object { sphere { <0,1,0>, .9 hollow on } material { M1 } }
intersection { box { -1, 1 } sphere { 0, 1.3 inverse } texture { T1 } scale .5 translate <2,1.5,1> }
light_source { <6,8,-9> rgb 1 media_interaction off media_attenuation on }
light_source { 0*x color rgb <.4,.4,.5> area_light <2,0,0> <0,0,2> 2, 2 translate <-6,9,-4> }
plane { y, -.01 hollow pigment { checker rgb 1 rgb .7 } finish { reflection .1 } }
camera { location <1, 3.5, -6> look_at <0,.7,0> angle 55 }
rainbow { angle 42.5 width 5 distance 1e4 direction <-.2,-.2,1> jitter 0 color_map { [0 rgbt <1,.5,1,1>] [.2 rgbt <.8,.3,1,.8>] [.5 rgbt <.2,.9,.2,.8>] [.8 rgbt <1,.2,.2,.8>] [1 rgbt <1,.2,.2,1>] } }
