// crand draws a number per light.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
sphere { <0,0.8,0>, 0.8 pigment { rgb <0.8,0.6,0.5> } finish { crand 0.3 } }
