// The second value of nearest_count ends the pretrace of finished blocks.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { nearest_count 6, 4 pretrace_end 0.01 } }
#include "room.inc"
sphere { <-0.4,0.4,0.3>, 0.4 pigment { rgb 0.85 } finish { RoomFinish } }
box { <0.1,0,-0.4>, <0.7,0.9,0.1> pigment { rgb 0.85 } finish { RoomFinish } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
