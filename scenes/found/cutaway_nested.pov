// Textures of all solids around a point of an untextured surface count alike, whatever their nesting; those without a texture
// do not count (spec 03 5.3).
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 5 }
camera { location <0, 0.5, -3> }
intersection {
  sphere { 0, 0.9 }
  sphere { 0, 2 }
  union { sphere { -x, 1.3 pigment { rgb 1 } } sphere { x, 1.2 pigment { rgb <1, 0.5, 0> } } box { <-9, 0.4, -9>, 9 } }
  intersection { sphere { 0, 2 } sphere { 0, 3 pigment { rgb x } } sphere { 0, 4 } }
  cutaway_textures
}
