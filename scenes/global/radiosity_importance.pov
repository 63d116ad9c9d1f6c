// Objects of little importance get few gather rays; one is hidden from them.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { count 100 error_bound 0.8 } }
#include "room.inc"
sphere { <-0.4,0.4,0.3>, 0.4 pigment { rgb <0.2,0.9,0.3> } finish { diffuse 0.2 ambient 0 emission 0.6 } radiosity { importance 0.2 } }
box { <0.1,0,-0.4>, <0.7,0.9,0.1> pigment { rgb <0.9,0.7,0.1> } finish { diffuse 0.3 ambient 0 emission 0.4 } no_radiosity }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
