// box clipped by a sphere
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare S = box { <-1, -0.9, -0.8>, <1, 0.9, 0.8> }
object { S clipped_by { sphere { <0.3, 0.2, -0.3>, 1.1 } } texture { Coat } interior_texture { pigment { rgb <0.9, 0.2, 0.2> } } }
