// A thin film: light that is reflected at its two faces interferes, 1 + A cos(2 pi t (cos(a) + cos(b)) / wavelength) for each colour; a is the angle of the
// light, b that of the eye (0 here), and the film counts as if it had no index of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 3*y direction -y right 4*x up 3*z }

light_source { <0.5, 2, -0.25>, rgb 0.7 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 irid { 0.3 thickness 0.8 } } }
