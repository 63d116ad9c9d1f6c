// brightness and gray_threshold act on every query.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { brightness 1.4 gray_threshold 0.5 } }
#include "room.inc"
sphere { <-0.4,0.4,0.3>, 0.4 pigment { rgb 0.85 } finish { RoomFinish } }
box { <0.1,0,-0.4>, <0.7,0.9,0.1> pigment { rgb 0.85 } finish { RoomFinish } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
