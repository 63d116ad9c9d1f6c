// Caustic inside a metal ring.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10  photons { spacing 0.02 radius 0.1 } }
#include "table.inc"
light_source { <3,6,-2> rgb 1 photons { refraction on reflection on } }
torus { 0.7, 0.15 pigment { rgb <0.9,0.7,0.3> } finish { ambient 0 diffuse 0.1 reflection 0.8 metallic } photons { target reflection on } translate <0.4,0.15,-0.2> }
