// Nested containers add up; one that is not hollow switches all off.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission 0.15 } } }
sphere { <-0.4,0.8,0>, 0.5 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission <0.6,0.2,0> } } }
sphere { <0.6,0.8,0>, 0.4 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
