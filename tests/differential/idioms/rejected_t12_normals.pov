#version 3.7; global_settings { assumed_gamma 1 }
#declare N1 = normal { bumps .6 scale .2 }
#declare N2 = normal { gradient y .5 slope_map { [0 <0,1>] [.5 <1,1>] [.5 <1,0>] [1 <0,0>] } scale .3 }
#declare N3 = normal { checker normal { wrinkles .8 scale .2 } normal { N1 } scale .5 }
#declare N4 = normal { average normal_map { [1 N1] [1 N2] } }
#declare N5 = normal { facets coords .3 size .2 .9 }
#declare N6 = normal { quilted .8 control0 0 control1 1 scale .4 no_bump_scale }
#macro S(i, N) sphere { <1.1*mod(i,3)-1.1, 1.1*div(i,3)-.5, 0>, .5 pigment { rgb <.8,.8,.7> } normal { N } finish { specular .4 } } #end
S(0,N1) S(1,N2) S(2,N3) S(3,N4) S(4,N5) S(5,N6)
camera { location -4.2*z look_at 0 } light_source { <4,6,-6> 1 }
