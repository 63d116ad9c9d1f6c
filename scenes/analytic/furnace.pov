// A white furnace: in surroundings of even radiance 0.5 a convex body of albedo 0.8 has the radiance 0.4 everywhere.
#version 3.7;
global_settings { assumed_gamma 1 
  radiosity { pretrace_start 0.08 pretrace_end 0.02 count 200 nearest_count 5 error_bound 0.5 recursion_limit 1 brightness 1 normal off }
}
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

background { rgb 0.5 }
sphere { 0, 1 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
