// blob with a texture for each component
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
blob { threshold 0.4 sphere { <-0.7, 0, 0>, 1, 1 pigment { rgb <1, 0.3, 0.2> } } sphere { <0.6, 0.3, -0.2>, 1.1, 1.2 pigment { checker rgb 1, rgb <0.2, 0.4, 0.9> scale 0.2 } scale <1, 0.8, 1> } cylinder { <-0.5, -0.8, 0>, <0.7, -0.6, 0.3>, 0.6, 1 texture { Coat } rotate 10 * z } finish { phong 0.5 } }
