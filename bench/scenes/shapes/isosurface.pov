// Wavy and noisy implicit surfaces.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare F_noise = function { pattern { bozo scale 0.4 } }
isosurface { function { x*x + y*y + z*z - 1 + 0.25 * sin(6*x) * sin(6*y) * sin(6*z) } contained_by { box { -1.3, 1.3 } } max_gradient 5 accuracy 0.002 translate <-2.2, 0.4, 0> pigment { rgb <0.8, 0.5, 0.4> } }
isosurface { function { sqrt(x*x + y*y + z*z) - 1 + 0.4 * F_noise(x, y, z) } contained_by { sphere { 0, 1.1 } } max_gradient 3.5 translate <0.2, 0.5, 0> pigment { rgb <0.5, 0.8, 0.4> } }
isosurface { function { pow(sqrt(x*x + z*z) - 0.8, 2) + y*y - 0.1 - 0.05 * cos(8 * atan2(x, z)) } contained_by { box { <-1.4, -0.5, -1.4>, <1.4, 0.5, 1.4> } } max_gradient 2.5 rotate -35 * x translate <2.5, 0.4, 0> pigment { rgb <0.5, 0.5, 0.9> } }
isosurface { function { y + 0.15 * sin(3*x) * cos(2*z) } contained_by { box { <-5, -0.3, -3>, <5, 0.3, 5> } } max_gradient 1.3 translate -1.2 * y pigment { rgb <0.6, 0.6, 0.5> } }
