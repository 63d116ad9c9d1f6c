// Without the global block the finish is an ordinary one.
#version 3.7;
global_settings { assumed_gamma 1  }
#include "table.inc"
light_source { <3,4,-2> rgb 1 }
sphere { <-0.6,0.6,0>, 0.6 pigment { rgb <0.9,0.6,0.4> } interior { ior 1.4 } finish { ambient 0 diffuse 1 specular 0.3 subsurface { translucency <2,0.8,0.4> } } }
box { <0.3,0,-0.4>, <1.1,0.8,0.4> pigment { rgb <0.6,0.9,0.7> } interior { ior 1.4 } finish { ambient 0 diffuse 1 subsurface { translucency 1 } } }
