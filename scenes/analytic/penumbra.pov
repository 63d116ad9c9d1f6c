// The penumbra of a straight edge: a line of light, one unit long, as far above the edge as the edge is above the ground. The part of the light that is seen
// grows evenly from 0 to 1 over one unit; 129 sources stand for it.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 0.5*y direction -y right 4*x up 3*z }

light_source {
  <0, 2, 0> rgb 1
  area_light x, 0.001*z, 129, 1
}
box { <-9, 1, -9>, <0, 1.0001, 9> pigment { rgb 0 } }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0 diffuse 1 } }
