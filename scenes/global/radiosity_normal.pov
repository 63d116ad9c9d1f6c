// Perturbed normals take part when `normal on` is given.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { normal on count 60 } }
#include "room.inc"
sphere { <-0.4,0.45,0.3>, 0.45 pigment { rgb 0.85 } normal { bumps 0.6 scale 0.1 } finish { RoomFinish } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
