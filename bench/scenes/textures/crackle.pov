// Crackle as a pavement, as solid cells and as bumps.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> look_at <0, 0.8, 0> angle 45 }
light_source { <-20, 30, -30> rgb 1 }
plane { y, 0 pigment { crackle scale 0.6 turbulence 0.1 color_map { [0 rgb 0.1] [0.08 rgb 0.2] [0.12 rgb <0.7, 0.6, 0.5>] [1 rgb <0.9, 0.8, 0.7>] } } }
sphere { <-1.6, 1.3, 0>, 1.3 pigment { crackle solid scale 0.4 color_map { [0 rgb <1, 0.2, 0>] [1 rgb <0, 0.3, 1>] } } }
sphere { <1.6, 1.3, 0>, 1.3 pigment { rgb <0.8, 0.7, 0.5> } normal { crackle 0.6 form <1, 0, 0> scale 0.3 } finish { phong 0.7 } }
