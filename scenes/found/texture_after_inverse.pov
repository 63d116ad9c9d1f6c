// CSG and texts that are inverted are known to hold a texture only if a part of one is read afterwards: where none is
// known the whole object has the default texture (spec 03 5.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 3, -9> look_at <0, -0.2, 0> angle 42 }
#default { pigment { rgb <0.2, 0.3, 0.9> } finish { ambient 1 diffuse 0 } }
#declare Ball = merge { sphere { y, 0.7 } pigment { rgb <0.2, 0.8, 0.3> } inverse }
#declare Letter = text { ttf "cyrvetic.ttf" "O" 3, 0 translate -2 * z inverse pigment { rgb <0.9, 0.8, 0.2> } }
intersection { box { -1, 1 } object { Ball } cutaway_textures translate <-2.4, 1.1, 0> }
intersection { box { -1, 1 } object { Ball finish { ambient 0.8 } } cutaway_textures translate <0, 1.1, 0> }
intersection { box { -1, 1 } object { Ball interior_texture { pigment { rgb x } } inverse } cutaway_textures translate <2.4, 1.1, 0> }
intersection { box { -1, 1 } object { Letter } cutaway_textures translate <-2.4, -1.4, 0> }
intersection { box { -1, 1 } object { Letter inverse } cutaway_textures translate <0, -1.4, 0> }
intersection { box { -1, 1 } union { object { Ball material { } } } cutaway_textures translate <2.4, -1.4, 0> }
