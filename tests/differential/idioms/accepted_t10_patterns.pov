#version 3.7; global_settings { assumed_gamma 1 }
#declare M = color_map { [0 rgb <.1,.1,.4>] [.4 rgb <.8,.6,.2>] [.4 rgb <.9,.2,.2>] [1 rgb 1] }
#macro Ball(i, P) sphere { <mod(i,5)-2, div(i,5)-1, 0>, .45 pigment { P } } #end
#declare P0 = pigment { leopard color_map { M } scale .1 }
#declare P1 = pigment { mandel 20 color_map { M } translate <.5,0,0> scale .4 }
#declare P2 = pigment { crackle form <1,0,0> metric 1 color_map { M } scale .3 }
#declare P3 = pigment { radial frequency 8 sine_wave color_map { M } }
#declare P4 = pigment { quilted control0 1 control1 .5 color_map { M } scale .3 }
#declare P5 = pigment { spiral2 5 triangle_wave color_map { M } scale .3 }
#declare P6 = pigment { gradient x+y cubic_wave phase .3 color_map { M } scale .5 warp { turbulence .4 octaves 3 } }
#declare P7 = pigment { wood warp { repeat .5*x flip y } warp { black_hole 0, .4 strength .6 falloff 1.5 } color_map { M } scale .3 }
#declare P8 = pigment { cells color_map { M } scale .2 }
#declare P9 = pigment { pigment_pattern { checker rgb 0, rgb .7 scale .2 } pigment_map { [0 P0] [1 P3] } }
#declare PA = pigment { average pigment_map { [1 P0] [2 P4] [1 color rgb <0,1,0>] } }
#declare PB = pigment { object { torus { .3, .1 } rgb <1,1,0>, rgb <0,0,1> } }
#declare All = array[12] { P0, P1, P2, P3, P4, P5, P6, P7, P8, P9, PA, PB }
#for (I, 0, dimension_size(All,1)-1) Ball(I, All[I]) #end
camera { location <0,0,-5> look_at <0,0,0> } light_source { <2,4,-8> 1 }
