// the shadow of isosurface beyond the edge of the picture, on the ground and on a ball
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare S = isosurface { function { x*x + y*y + z*z - 1 + 0.25 * sin(6 * x) * sin(6 * y) * sin(6 * z) } contained_by { box { -1.3, 1.3 } } max_gradient 6 accuracy 0.002 }
object { S texture { Coat } scale 0.7 rotate 20 * y translate <1.2, 2.6, -3> }
sphere { <-0.3, -0.9, 0.5>, 0.7 texture { Coat } }
