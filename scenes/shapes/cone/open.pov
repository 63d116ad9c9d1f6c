// open cones and cylinders, straight and oblique
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
cone { <-1, -1, 0>, 0.7, <-0.8, 1, 0>, 0.3 open texture { Coat } }
cylinder { <0.9, -1, 0>, <1.2, 0.9, 0.6>, 0.5 open texture { Coat } }
