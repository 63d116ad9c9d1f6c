// Sweeps of glass, and one cut out of a box: what lies behind the first surface hangs on both ends of the chord through
// every sphere (spec 08 F).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 1, -6> look_at 0 angle 40 }
light_source { <3, 5, -5>, 1 }
plane { y, -1.6 pigment { checker rgb 0.9 rgb 0.4 } }
#declare Glass = texture { pigment { rgbf <0.9, 0.7, 0.5, 0.8> } }
sphere_sweep {
  b_spline 5 <-3, 0, 0>, 0.4 <-1.5, 0.4, 0.2>, 0.4 <0, -0.2, 0>, 0.5 <1.5, 0.4, 0.1>, 0.4 <3, 0, 0>, 0.3
  texture { Glass } interior { ior 1.3 } translate 0.9*y
}
difference {
  box { <-1.5, -0.6, 0>, <1.5, 0.8, 1> }
  sphere_sweep { cubic_spline 4 <-3, 0, 0>, 0.4 <-1, 0.4, 0>, 0.4 <1, -0.2, 0>, 0.5 <3, 0.4, 0.1>, 0.4 }
  pigment { rgb <0.9, 0.7, 0.5> } translate -0.9*y
}
