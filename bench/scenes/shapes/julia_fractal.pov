// Quaternion and hypercomplex Julia sets.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 rotate 30 * y translate <-2.2, 0.4, 0> pigment { rgb <0.8, 0.5, 0.4> } }
julia_fractal { <-0.162, 0.163, 0.56, -0.599> quaternion cube max_iteration 8 precision 20 translate <0.3, 0.4, 0> pigment { rgb <0.5, 0.8, 0.4> } }
julia_fractal { <-0.1, 0.1, -0.7, 0.05> hypercomplex sqr max_iteration 8 precision 25 translate <2.6, 0.4, 0> pigment { rgb <0.5, 0.5, 0.9> } }
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
