// Hills of 300 by 300 samples.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
height_field { function 300, 300 { 0.45 + 0.2 * sin(x * 17) * cos(y * 13) + 0.15 * sin(x * 41 + y * 23) + 0.1 * cos(y * 61 - x * 37) } smooth translate <-0.5, -0.5, -0.5> scale <8, 1.6, 8> pigment { rgb <0.5, 0.7, 0.4> } }
