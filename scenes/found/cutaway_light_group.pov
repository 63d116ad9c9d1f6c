// What is cut away from a body may be a light_group, alone or in a union: it is an intersection then, whose parts stay
// without textures and show those of the body (spec 03 5.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at 0 }
light_source { <-50, 80, -100>, 1 }
difference {
  sphere { 0, 1.4 pigment { rgb <1, 0.6, 0.4> } }
  light_group { box { <-2, -0.2, -2>, <0.5, 2, 0.2> } }
  cutaway_textures
  translate <-2, 0, 0>
}
difference {
  sphere { 0, 1.4 pigment { rgb <0.6, 1, 0.4> } }
  union { light_group { box { <-2, -0.2, -2>, <0.5, 2, 0.2> } } cylinder { -2*z, 2*z, 0.3 translate x } }
  cutaway_textures
  translate <2, 0, 0>
}
