// A tight error bound and many rays: close to the true solution of two bounces.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { count 200 error_bound 0.4 nearest_count 8 low_error_factor 0.8 minimum_reuse 0.004 pretrace_end 0.01 } }
#include "room.inc"
sphere { <-0.4,0.4,0.3>, 0.4 pigment { rgb 0.85 } finish { RoomFinish } }
box { <0.1,0,-0.4>, <0.7,0.9,0.1> pigment { rgb 0.85 } finish { RoomFinish } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
