// A jittered area light.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 area_light 2*x, 2*z, 4, 4 jitter }
sphere { <0,0.8,0>, 0.8 pigment { rgb <0.8,0.6,0.5> } }
