// A Lambertian plane under a point light that fades: rho cos(a) 2 / (1 + (d/D)^2), D = 2.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

#declare White = texture { pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
light_source { <0.5, 2, -0.25> rgb 0.7 fade_distance 2 fade_power 2 }
plane { y, 0 texture { White } }
