#version 3.0
global_settings { assumed_gamma 2.2 }
#include "colors.inc"
camera { location <0,0,-4> look_at 0 }
light_source { <4,5,-5> color White }
sphere { 0, 1 pigment { color rgbt <1,1,1,1> } halo { emitting spherical_mapping linear turbulence 1 color_map { [0 color rgbt <1,0,0,1>] [1 color rgbt <1,1,0,-1>] } samples 10 } hollow }
