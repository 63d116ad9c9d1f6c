// interior: fade distance only
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6.5> look_at <0, 0.9, 0> angle 42 }
light_source { <-3, 7, -4> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.9, 0.8>] [1 rgb <0.2, 0.4, 0.8>] } } }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.55, 0.6, 0.7> } }
plane { -z, -4 pigment { gradient x color_map { [0.5 rgb 0.9] [0.5 rgb <0.2, 0.3, 0.5>] } scale 0.6 rotate 20*z } }
#declare Glass = texture { pigment { rgbf <0.97, 0.99, 0.98, 0.9> } finish { ambient 0 diffuse 0.05 specular 0.5 roughness 0.01 reflection 0.08 } }
#declare Inside = interior { ior 1.2 fade_distance 1 }
sphere { <-1.2, 1, 0>, 1 texture { Glass } interior { Inside } }
intersection { plane { -z, 0.7 } plane { z, 0.7 } plane { <1, 0.7, 0>, 0.55 } plane { <-1, 0.7, 0>, 0.55 } plane { -y, 0.7 } rotate 25*y translate <1.3, 0.75, 0> texture { Glass } interior { Inside } }
