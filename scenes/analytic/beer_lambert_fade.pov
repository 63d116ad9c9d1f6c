// The same law by fade_power 1001 of an interior: what is left of each colour is exp(-(1 - c) d / D).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

plane { y, -1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb 0.9 } }
intersection {
  box { <-2, 0, -2>, <2.5, 3, 2> }
  plane { <-0.5, 1, 0>, 0 translate -2*x }
  pigment { rgbt 1 }
  finish { ambient 0 diffuse 0 }
  interior { ior 1 fade_distance 1.5 fade_power 1001 fade_color <0.2, 0.5, 0.8> }
}
