// Outdoor light: an object under a gradient sky, no light source.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 80 error_bound 0.8 } }
#include "table.inc"
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9,0.8,0.6>] [1 rgb <0.2,0.4,0.9>] } } }
torus { 0.7, 0.25 pigment { rgb <0.9,0.5,0.3> } finish { diffuse 0.8 ambient 0 } translate 0.25*y }
sphere { <0,0.9,0>, 0.4 pigment { rgb 0.9 } finish { diffuse 0.8 ambient 0 } }
