// The second diffuse value lets light through a sheet.
#version 3.7;
global_settings { assumed_gamma 1  radiosity { count 60 } }
#include "room.inc"
disc { <0,0.8,0>, vnormalize(<0.4,1,-0.3>), 0.7 pigment { rgb <0.9,0.6,0.3> } finish { diffuse 0.4, 0.5 ambient 0 } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
