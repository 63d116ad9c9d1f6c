// Photons in a scattering medium.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10  photons { spacing 0.05 media 60 radius 0.2,1,0.3,1 } }
#include "table.inc"
light_source { <3,6,-2> rgb 1 photons { refraction on reflection on } }
sphere { <-0.8,0.75,0>, 0.7 pigment { rgbt <1,1,1,0.95> } finish { ambient 0 diffuse 0 reflection 0.08 } interior { ior 1.5 } photons { target refraction on reflection on collect off } }
box { <-2,0.02,-1.2>, <1,1.6,1.2> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 1, 0.15 } } } photons { collect off } }
