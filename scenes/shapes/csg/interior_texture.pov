// the inside of shells
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
difference { sphere { 0, 1 } box { <-0.1, -2, -2>, <2, 2, 0.2> } texture { pigment { rgb <1, 0.6, 0.2> } } interior_texture { pigment { rgb <0.2, 0.4, 0.9> } } translate -1 * x }
union { sphere { 0, 0.8 clipped_by { plane { y, 0.2 rotate -30 * x } } } cylinder { -0.9 * y, -0.4 * y, 0.9 open } texture { pigment { rgb <1, 0.6, 0.2> } } interior_texture { pigment { rgb <0.2, 0.4, 0.9> } } translate 1.2 * x }
