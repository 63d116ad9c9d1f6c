// A jittered rainbow.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
rainbow { angle 14 width 8 distance 20 direction <0,-0.2,1> jitter 0.3 color_map { [0 rgbt <0.6,0.2,0.9,0.4>] [0.5 rgbt <0.2,0.9,0.2,0.4>] [1 rgbt <1,0.2,0.1,0.4>] } }
sphere { <0,0.8,0>, 0.8 pigment { rgb <0.8,0.6,0.5> } }
