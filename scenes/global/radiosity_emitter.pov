// Light from an emissive patch only.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { count 200 nearest_count 10 error_bound 0.8 } }
#include "room.inc"
sphere { <-0.4,0.4,0.3>, 0.4 pigment { rgb 0.85 } finish { RoomFinish } }
box { <0.1,0,-0.4>, <0.7,0.9,0.1> pigment { rgb 0.85 } finish { RoomFinish } }
box { <-0.4,1.985,-0.4>, <0.4,1.99,0.4> pigment { rgb 1 } finish { diffuse 0 ambient 0 emission 5 } }
