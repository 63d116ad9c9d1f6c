// Method 3 with jitter.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { jitter 0.5 emission 1 density { spherical color_map { [0 rgb 0] [0.4 rgb <0.6,0.3,0.1>] [1 rgb 1] } scale 0.8 translate 0.8*y } } } }
sphere { <0.2,0.6,0.2>, 0.35 pigment { rgb <1,0.5,0.3> } }
