// The form factor of a point to a parallel disc: of radiance 1 and radius 1, one unit above a white plane.
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { pretrace_start 0.08 pretrace_end 0.01 count 1600 nearest_count 1 error_bound 0.02 minimum_reuse 0.001 maximum_reuse 0.01 recursion_limit 1 brightness 1 }
}
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 0.5*y direction -y right 4*x up 3*z }

disc { y, y, 1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb 1 } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
