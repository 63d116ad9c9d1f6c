// Spacing from count, automatic radius.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10  photons { count 20000 } }
#include "table.inc"
light_source { <3,6,-2> rgb 1 photons { refraction on reflection on } }
sphere { <-0.8,0.75,0>, 0.7 pigment { rgbt <1,1,1,0.95> } finish { ambient 0 diffuse 0 reflection 0.08 } interior { ior 1.5 } photons { target refraction on reflection on collect off } }
