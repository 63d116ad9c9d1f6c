// An integrating sphere: a lamp in the middle of a hollow sphere of albedo 0.5. Every bounce of light adds half of the one before, evenly: after four of
// them the radiance is 0.5 E (1 + 1/2 + 1/4 + 1/8 + 1/16), with E = 0.3.
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { pretrace_start 0.08 pretrace_end 0.04 count 60 nearest_count 4 error_bound 0.8 recursion_limit 4 brightness 1 adc_bailout 0.0001 }
}
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 0 direction -y right 4*x up 3*z }

light_source { 0, rgb 0.3 }
sphere { 0, 3 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }
