// Fog: what is left of a wall of radiance 0.9 is exp(-d/D), and the fog of radiance 0.2 takes the rest. The wall is inclined, so that d varies.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

fog { fog_type 1 distance 3 rgb 0.2 }
plane { <1, 2, 0>, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb 0.9 } }
