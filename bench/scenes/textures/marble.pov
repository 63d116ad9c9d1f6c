// A wall of turbulent marble and a floor of agate.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1.5, 0> angle 55 }
light_source { <-20, 30, -30> rgb 1 }
plane { -z, -3 pigment { marble turbulence 1.2 octaves 6 color_map { [0 rgb <0.9, 0.9, 0.85>] [0.7 rgb <0.6, 0.6, 0.65>] [1 rgb <0.2, 0.2, 0.3>] } rotate 40*z } }
plane { y, 0 pigment { agate agate_turb 1.5 scale 1.5 } }
sphere { <0, 1.3, 0>, 1.3 pigment { granite turbulence 0.4 scale 0.8 color_map { [0 rgb <0.3, 0.1, 0.1>] [0.5 rgb <0.8, 0.6, 0.5>] [1 rgb 1] } } finish { specular 0.6 } }
