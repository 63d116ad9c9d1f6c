// blob with a pattern in its own coordinates
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare S = blob { threshold 0.5 sphere { <-0.7, 0, 0>, 1, 1 } sphere { <0.6, 0.3, -0.2>, 1.1, 1.2 } cylinder { <-0.5, -0.8, 0>, <0.7, -0.6, 0.3>, 0.6, 1 } sphere { <0.1, 0.7, -0.7>, 0.6, -1 } }
object { S uv_mapping pigment { checker rgb <0.9, 0.8, 0.3>, rgb <0.2, 0.3, 0.6> scale 0.13 } finish { ambient 0.2 diffuse 0.8 } rotate 20 * y }
