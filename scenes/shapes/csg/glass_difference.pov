// a refracting die
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
difference { intersection { box { -1, 1 } sphere { 0, 1.45 } } sphere { -z, 0.3 } sphere { <1, 0.4, 0.3>, 0.25 } sphere { <1, -0.4, -0.3>, 0.25 } cylinder { 0, 2 * y, 0.3 } pigment { rgbf <0.9, 1, 0.95, 0.9> } finish { ambient 0 diffuse 0.1 reflection 0.1 specular 0.5 } interior { ior 1.4 } rotate <-15, 30, 0> }
