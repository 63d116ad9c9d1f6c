// Caustics through and from layered and mapped textures, and from a mirror with an exponent.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 photons { spacing 0.02 radius 0.15 } }
#include "table.inc"
light_source { <3,6,-2> rgb <1,0.9,0.8> photons { refraction on reflection on } }
sphere { <-1,0.65,0>, 0.6 texture { pigment { rgbf <1,0.8,0.7,0.9> } finish { diffuse 0 reflection 0.2 } } texture { pigment { rgbf <0.9,0.9,1,0.9> } finish { diffuse 0 reflection 0.1 conserve_energy } }
  interior { ior 1.4 } photons { target refraction on reflection on collect off } }
box { <-0.5,0,-0.1>, <0.5,1.2,0.1> texture { gradient y texture_map { [0.2 pigment { rgbf <1,0.6,0.5,0.9> } finish { diffuse 0 }] [0.8 pigment { rgbf <0.5,0.8,1,0.8> } finish { diffuse 0 reflection 0.3 }] } }
  interior { ior 1.3 } rotate 30*y translate <0.4,0.01,0.6> photons { target refraction on reflection on collect off } }
box { <-0.4,0,-0.05>, <0.4,1,0.05> pigment { rgb <0.9,0.7,0.3> } finish { diffuse 0 reflection { 0.3, 0.8 metallic } reflection_exponent 1.5 } rotate -35*y translate <1.4,0.01,0.3> photons { target reflection on collect off } }
