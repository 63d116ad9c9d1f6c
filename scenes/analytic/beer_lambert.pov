// Beer and Lambert: an absorbing wedge of glass without refraction in front of a wall of radiance 0.9. Below x the wedge is (x + 2) / 2 thick; what is left is exp(-a d).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

plane { y, -1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb 0.9 } }
intersection {
  box { <-2, 0, -2>, <2.5, 3, 2> }
  plane { <-0.5, 1, 0>, 0 translate -2*x }
  pigment { rgbt 1 } hollow
  interior { media { absorption <0.3, 0.6, 1.2> } }
}
