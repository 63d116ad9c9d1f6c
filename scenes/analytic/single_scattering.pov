// Single scattering: a wedge of mist in front of black, lit from behind the camera by parallel light. Below x it is (x + 2) / 2 thick; what comes back of the
// light E = 1.2 is (1 - exp(-2 s d)) / 2 of it, isotropically scattered without further loss of brightness.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

light_source { 9*y, rgb 1.2 parallel point_at 0 }
intersection {
  box { <-2, 0, -2>, <2.5, 3, 2> }
  plane { <-0.5, 1, 0>, 0 translate -2*x }
  pigment { rgbt 1 } hollow
  interior { media { scattering { 1, <0.2, 0.5, 1> } method 3 intervals 1 samples 200, 200 } }
}
