// What is taken away ends level with a joint of the lathe's outline: by rounding a point there lies in both segments of
// the lathe, and so outside (spec 03 4.15).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 }
background { rgb 1 }
difference {
  lathe { quadratic_spline 5, <0, -1>, <1, -1>, <0.7, 0>, <1, 0.5>, <0, 1> }
  prism { cubic_spline 0, 1, 7, <-1, -1>, <0, -1>, <1, 0>, <0.5, 1>, <-0.5, 0.5>, <0, -1>, <1, 0> }
  scale 2
  pigment { rgb 0.2 }
  finish { reflection 1 }
}
plane { y, -0.5 pigment { rgb <0.3, 0.6, 0.2> } }
