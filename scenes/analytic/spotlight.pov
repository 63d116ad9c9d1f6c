// A Lambertian plane under a spotlight of even strength whose light falls off with the cosine of the angle to its axis to the power of its tightness.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

light_source { <0, 3, 0> rgb 1 spotlight point_at 0 radius 60 falloff 60 tightness 7 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0 diffuse 1 } }
