// glass given to the whole and to the parts
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
union { sphere { <-1.2, 0, 0>, 0.7 interior { ior 1.5 fade_distance 0.7 fade_power 2 } } box { <-0.1, -0.6, -0.6>, <1.2, 0.7, 0.6> } pigment { rgbf <0.8, 0.95, 0.9, 0.9> } finish { ambient 0 diffuse 0.2 specular 0.6 } interior { ior 1.2 } rotate 10 * y }
