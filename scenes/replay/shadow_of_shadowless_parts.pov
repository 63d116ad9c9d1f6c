// A part of a union that casts no shadow by itself casts one where the union does, but is not remembered as what blocked
// the light last: beyond the bounds of the union there is no shadow (spec 08 D).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -5> look_at <0, 0.5, 0> }
light_source { <5, 4, -4>, 1 }
union {
  cylinder { <-0.2, -0.5, 0>, <0.3, 2, 0>, 0.5 no_shadow }
  sphere { <-1, 0, 1>, 0.6 }
  split_union off
  pigment { rgb <0.8, 0.3, 0.2> }
  bounded_by { plane { y, 0.6 } }
}
plane { y, -0.5 pigment { rgb 0.7 } }
plane { -z, -3 pigment { rgb 0.9 } }
