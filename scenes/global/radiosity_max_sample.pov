// max_sample clamps what a gather ray may bring.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { max_sample 0.3 } }
#include "room.inc"
sphere { <-0.4,0.4,0.3>, 0.4 pigment { rgb 0.85 } finish { RoomFinish } }
box { <0.1,0,-0.4>, <0.7,0.9,0.1> pigment { rgb 0.85 } finish { RoomFinish } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
box { <-0.2,1.2,0.9>, <0.2,1.6,0.99> pigment { rgb 1 } finish { diffuse 0 ambient 0 emission 4 } }
