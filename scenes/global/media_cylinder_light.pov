// A cylinder light lights a stretch of the medium.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,4,-3> rgb 1.2 cylinder point_at <0,0.8,0> radius 0.3 falloff 0.5 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 1, 0.5 } intervals 5 method 2 samples 3 } } }
