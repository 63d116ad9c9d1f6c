// Before 3.7 ambient light stays on top of radiosity.
#version 3.6;
global_settings { assumed_gamma 1 ambient_light 0.5 radiosity { count 40 } }
#include "room.inc"
sphere { <0,0.5,0>, 0.5 pigment { rgb 0.8 } finish { diffuse 0.7 ambient 0.3 } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
