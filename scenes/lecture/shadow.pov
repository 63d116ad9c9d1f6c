// A floor half in the shadow of a board: there it shows only its ambient and emitted light, 0.2 and 0.1 of white.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 10, 0> direction -y right 4*x up 4*z }
light_source { <0, 20, 0> rgb 1 parallel point_at 0 }

plane { y, 0 pigment { rgb 1 } finish { ambient 0.2 emission 0.1 diffuse 0.5 } }
box { <-2, 12, -2>, <0, 12.1, 2> pigment { rgb 1 } }  // above the camera: only its shadow is seen
