// Before 3.5 media default to method 1 with ten intervals of one sample.
#version 3.1;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission 0.8 density { spherical color_map { [0 rgb 0] [0.4 rgb <0.6,0.3,0.1>] [1 rgb 1] } scale 0.8 translate 0.8*y } } } }
