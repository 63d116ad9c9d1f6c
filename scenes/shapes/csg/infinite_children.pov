// planes and unbounded quadrics in CSG
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
intersection { plane { y, 0.6 } plane { -y, 0.8 rotate 10 * x } plane { x, 1 } plane { -x, 1.1 rotate 20 * z } plane { z, 0.8 } plane { -z, 0.7 } texture { Coat } rotate 25 * y translate -1 * x }
intersection { quadric { <1, 0, 1>, 0, 0, -0.3 } plane { y, 0.9 } plane { -y, 0.9 } texture { Coat } translate 1.3 * x }
