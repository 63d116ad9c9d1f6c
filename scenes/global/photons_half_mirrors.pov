// Photons that are reflected and let through many times: what ends their way.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12  photons { spacing 0.03 radius 0.15 } }
#include "table.inc"
light_source { <3,6,-2> rgb 1 photons { refraction on reflection on } }
union {
  box { <-1.2,0.3,-0.8>, <0.2,0.35,0.6> }
  box { <-1.2,0.6,-0.8>, <0.2,0.65,0.6> rotate x*8 }
  pigment { rgbt <1,0.9,0.8,0.5> } finish { ambient 0 diffuse 0 reflection 0.5 } interior { ior 1 }
  photons { target refraction on reflection on }
}
