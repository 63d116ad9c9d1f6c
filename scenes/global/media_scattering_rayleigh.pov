// Scattering of type 4 around a shadow-casting ball.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1.2 spotlight point_at <0,0.8,0> radius 12 falloff 16 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 4, 0.4 } intervals 1 samples 8 } } }
sphere { <0.2,0.6,0.2>, 0.35 pigment { rgb <1,0.5,0.3> } }
