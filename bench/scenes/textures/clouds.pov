// A sky of wrinkles and bozo over water with two sets of waves.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "skies.inc"
camera { location <0, 2, -7> look_at <0, 3, 0> angle 70 }
light_source { <-200, 300, -300> rgb 1 }
sky_sphere { S_Cloud1 }
plane { y, 0 pigment { rgb <0.1, 0.2, 0.35> } normal { bumps 0.3 scale <0.6, 0.2, 0.3> } finish { reflection 0.3 specular 0.5 } }
