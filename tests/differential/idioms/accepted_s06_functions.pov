#version 3.6;
#include "functions.inc"
#declare F = function(x,y,z) { sqrt(x*x+y*y) - .6 + .1*sin(8*z) }
#declare G = function { F(x,y,z) * F(x,z,y) - .05 }
#declare P = function { pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } } }
#declare W = function { pattern { wood turbulence .2 scale .3 } }
isosurface { function { G(x,y,z) + f_noise3d(x*4,y*4,z*4)*.1 } contained_by { box { -1.3, 1.3 } } max_gradient 6 accuracy .005 pigment { function { W(x,y,z) } color_map { [0 rgb <.8,.6,.3>] [1 rgb <.3,.15,.05>] } } }
plane { y, -1.4 pigment { function { abs(sin(x*3)*sin(z*3)) } color_map { [0 rgb .2] [1 rgb .9] } } normal { function { f_ridged_mf(x,y,z,.1,3,4,.7,2,1) } .2 } }
#debug concat(str(F(1,2,3),0,9), " ", str(P(.1,.2,.3).gray,0,6), " ", str(f_sphere(1,1,1,.5),0,9), " ", str(f_r(1,2,2),0,4), "\n")
camera { location <2,2,-4> look_at 0 angle 40 }
light_source { <4,6,-8> 1 }
