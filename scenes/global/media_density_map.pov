// density_map and a patterned density inside.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission 1.3 density { gradient y density_map { [0.2 spherical scale 0.8 translate 0.7*y] [0.8 bozo scale 0.3] } scale 1.7 } } } }
sphere { <0.2,0.6,0.2>, 0.35 pigment { rgb <1,0.5,0.3> } }
