// Rays through a lens are as many as their colours ask for, in radiosity's pretrace, too: with direct light (spec 07 2.9).
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { pretrace_start 0.08 pretrace_end 0.04 count 20 error_bound 0.5 recursion_limit 1 }
}
camera { location <0, 2, -6> look_at 0.5 * y angle 40 focal_point 0.5 * y aperture 0.4 blur_samples 9 }
light_source { <5, 9, -7>, 1 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 } }
sphere { y, 1 pigment { rgb <1, 0.5, 0.3> } finish { ambient 0 } }
