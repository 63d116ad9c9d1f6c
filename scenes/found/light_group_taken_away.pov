// Light groups within differences, and inverted: they are unions, whose lights light what is theirs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 2.5, -5> look_at <0, 0, 0> }
light_source { <4, 6, -9>, 0.8 }
#default { pigment { rgb <0.9, 0.8, 0.6> } finish { ambient 0.2 } }
difference {
  box { <-2, -1, -1>, <0, 1, 1> }
  union {
    light_group { light_source { <-1, 2, -2>, <1, 0.2, 0.1> } sphere { <-2, 1, -1>, 0.9 } }
    sphere { <0, -1, -1>, 0.6 }
  }
}
intersection {
  box { <0.4, -1, -1>, <2, 1, 1> }
  light_group { light_source { <1, 4, 0>, <0.1, 0.2, 1> } cylinder { <1.2, -2, 0>, <1.2, 2, 0>, 0.4 } box { <0, 0, -2>, <3, 0.3, 2> } }
  inverse
}
