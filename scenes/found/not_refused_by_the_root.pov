// Rays along the upper face of a box: that of all objects does not refuse them, whose corner is a sum in double precision.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location <6, 1.03125, -8> look_at <0, 1.03125, 0> right 10*x up 7.5*y }
box { <-0.5, 0, 0>, <0, 1.25, 0.5> pigment { rgb x } }
sphere { <0, -0.2, 0>, 0.958455967903 pigment { rgb y } }
sphere { 2*z, 0.1 }
sphere { 2*z, 0.1 }
sphere { -2*z, 0.1 }
