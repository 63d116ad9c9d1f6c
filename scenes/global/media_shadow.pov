// Light attenuated by an absorbing container falls on floor and ball.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <5,4,-1> rgb 1 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { absorption <0.4,0.8,1.4> density { spherical color_map { [0 rgb 0] [0.4 rgb <0.6,0.3,0.1>] [1 rgb 1] } scale 0.8 translate 0.8*y } } } }
sphere { <-2,0.4,0.5>, 0.4 pigment { rgb 0.9 } }
