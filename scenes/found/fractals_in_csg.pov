// What a fractal's search meets next often lies in the same place: the first is seen, with its normal (spec 04 8).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 1, -6> look_at 0 angle 60 }
light_source { <5, 9, -9>, rgb 1 }
#default { pigment { rgb <1, 0.8, 0.5> } }
intersection {
  julia_fractal { <-0.2, 0.4, 0.3, -0.2> hypercomplex cos slice <0, 1, 0, 1>, 0 }
  sphere { 0, 6 }
  scale 0.5 translate -x
}
difference {
  julia_fractal { <-0.2, 0.4, 0.3, -0.2> hypercomplex exp slice <0, 1, 0, 1>, 0 }
  sphere { <1, 1, -2>, 1 }
  scale 0.5 translate x
}
