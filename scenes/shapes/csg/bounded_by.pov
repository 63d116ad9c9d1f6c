// bounds that cut their object, and bounds of CSG
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
box { -0.6, 0.6 bounded_by { sphere { 0, 0.7 } } rotate 20 * y texture { Coat } translate -1.3 * x }
difference { box { -0.7, 0.7 } sphere { <0.2, 0.2, -0.7>, 0.5 } bounded_by { sphere { 0, 0.95 } } rotate <10, 25, 0> texture { Coat } translate 0.2 * x }
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.18, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.82, 0, 0, 0, 0, 1, 0, -2.18, 0, 0.8281> bounded_by { sphere { 0, 1.3 } } scale 0.6 rotate -40 * x texture { Coat } translate 1.8 * x }
