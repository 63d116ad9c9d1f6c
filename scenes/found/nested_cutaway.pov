// Cut surfaces of nested differences show the body that is cut, not what cuts it (spec 03 5.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <6, 6, -9> look_at 0 angle 40 }
light_source { <10, 10, -10>, 1 }
background { rgb 1 }
difference {
  union {
    difference { sphere { 0, 2 pigment { rgb x } } sphere { 0, 1.7 pigment { rgb y } } }
    sphere { 0, 1.7 pigment { rgb <1, 0.8, 0.6> } }
    difference { cylinder { 0, 3*y, 0.4 pigment { rgb z } } cylinder { y, 4*y, 0.2 pigment { rgb 0.5 } } }
  }
  box { <-5, -5, -5>, <5, 5, 0> }
  cutaway_textures
}
