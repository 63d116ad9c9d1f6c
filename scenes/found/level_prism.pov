// A prism with a curved outline, cut level with its vertices: the last bit of a root decides what is inside
// (spec 08 F).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 2.5, -4> look_at 0 angle 40 }
light_source { <3, 5, -5>, 1 }
#declare Front = box { <-2, -2, -2>, <2, 2, 0> }
difference {
  prism { cubic_spline 0, 0.5, 7 <0, -1>, <0.6, 0>, <0, 1>, <-0.6, 0>, <0, -1>, <0.6, 0>, <0, 1> }
  object { Front } pigment { rgb <1, 0.7, 0.3> } rotate 10*y
}
