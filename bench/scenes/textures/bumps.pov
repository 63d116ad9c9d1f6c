// Normals of every kind that computes noise.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> look_at <0, 0.8, 0> angle 45 }
light_source { <-20, 30, -30> rgb 1 }
plane { y, 0 pigment { rgb 0.7 } normal { wrinkles 0.6 scale 0.7 } }
sphere { <-2.8, 1, 0>, 1 pigment { rgb <0.8, 0.5, 0.4> } normal { bumps 0.5 scale 0.15 } finish { phong 0.5 } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.5, 0.8, 0.4> } normal { granite 0.3 scale 0.8 } finish { phong 0.5 } }
sphere { <2.8, 1, 0>, 1 pigment { rgb <0.4, 0.5, 0.8> } normal { dents 0.9 scale 0.2 } finish { phong 0.5 } }
sphere { <0, 1, 3>, 1 pigment { rgb 0.8 } normal { bozo 0.7 turbulence 0.3 scale 0.2 } finish { phong 0.5 } }
