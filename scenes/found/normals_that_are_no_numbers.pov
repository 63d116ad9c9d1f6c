// Where a layer's normal is no number its colour is none either: black, with and without light, through glass, in
// mirrors and whatever else shares the texture; but not below an opaque layer (spec 06 3.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.8, 0> angle 42 }
light_source { <-4, 9, -7>, 0.8 }
background { rgb 0.3 }
#declare Bare = finish { ambient 0.4 diffuse 0.5 };
#declare None = normal { function { select(x, sqrt(-1), 0) } };
plane { y, 0 pigment { rgb <0.5, 0.6, 0.4> } finish { Bare reflection 0.3 } }
sphere { <-2.2, 1, 0>, 1 pigment { rgb x } finish { Bare } normal { None translate -2.2 * x } }
sphere {
  <0, 1, 0>, 1
  texture { pigment { rgb y } finish { Bare } }
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } normal { None } }
}
sphere {
  <2.2, 1, 0>, 1
  texture { pigment { rgb z } finish { Bare } normal { None } }
  texture { pigment { rgb 0.7 } finish { Bare } }
}
box { <-1, 1.2, -3>, <1, 1.8, -2.9> pigment { rgbt <0.2, 0.2, 0.2, 0.7> } finish { Bare } }
