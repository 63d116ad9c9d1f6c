// Atmospheric media with a spotlight, and fog over it.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-1> rgb 1.5 spotlight point_at <0,0,0> radius 8 falloff 14 media_attenuation on }
media { scattering { 2, 0.02 } intervals 3 samples 6 }
fog { distance 60 rgb <0.6,0.65,0.7> }
sphere { <0.2,0.6,0.2>, 0.35 pigment { rgb <1,0.5,0.3> } }
