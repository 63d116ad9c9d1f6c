// Caustics of a glass cylinder: light that is reflected totally inside it is not filtered, and not mirrored once more.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 photons { spacing 0.02 radius 0.15 max_trace_level 12 } }
#include "table.inc"
light_source { <3,6,-2> rgb 1 photons { refraction on reflection on } }
cylinder { <-0.6,0.01,0>, <-0.6,1.5,0>, 0.6 pigment { rgbf <0.9,1,0.95,0.8> } finish { ambient 0 diffuse 0 reflection 0.15 } interior { ior 1.5 } photons { target refraction on reflection on collect off } }
