// Gather rays are reflected and refracted while the trace level allows.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 radiosity { count 60 } }
#include "room.inc"
sphere { <-0.4,0.45,0.3>, 0.45 pigment { rgb 0 } finish { diffuse 0 ambient 0 reflection 0.9 } }
sphere { <0.4,0.35,-0.3>, 0.35 pigment { rgbt 1 } finish { diffuse 0 ambient 0 reflection { 0,1 fresnel } conserve_energy } interior { ior 1.5 } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 }
