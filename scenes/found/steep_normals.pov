// The strength of a height normal is its amount times -5 times the quotient of 0.02 and the accuracy: mirrors before a
// backdrop whose grains are 1e-12 wide.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.1, 1.3, -4> look_at <0.2, 0.1, 0> }
box { -9, 9 hollow pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
plane { y, -0.3 pigment { rgb 0 } normal { gradient x, 1 } finish { ambient 0 diffuse 0 reflection 1 } }
sphere { <0.3, 0.6, 0>, 0.8 pigment { rgb 0 } normal { function { sin(x*3)*cos(z*2) } 0.5 } finish { ambient 0 diffuse 0 reflection 1 } }
