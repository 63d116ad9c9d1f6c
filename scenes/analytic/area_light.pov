// A Lambertian plane under a square of light: the mean of cos(a) over the square, which has a closed form. The sources stand on a grid of 33 x 33.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 3*y direction -y right 4*x up 3*z }

light_source {
  <0, 2, 0> rgb 1
  area_light 2*x, 2*z, 33, 33
  area_illumination on
}
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0 diffuse 1 } }
