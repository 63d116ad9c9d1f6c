// clips before and after transformations, inverted, shared with a bound
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
sphere { 0, 0.8 clipped_by { plane { x, 0.2 } } rotate 40 * z texture { Coat } interior_texture { pigment { rgb <0.9, 0.2, 0.2> } } translate -1.4 * x }
sphere { 0, 0.8 rotate 40 * z clipped_by { plane { x, 0.2 } box { <-0.4, -0.3, -2>, <0.3, 0.5, 0> inverse } } texture { Coat } interior_texture { pigment { rgb <0.9, 0.2, 0.2> } } translate 0.2 * x }
cylinder { -y, y, 0.5 open bounded_by { sphere { 0, 0.8 } } clipped_by { bounded_by } texture { Coat } translate 1.7 * x }
