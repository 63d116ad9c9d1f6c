// Images with `filter all` in a pigment_map block all light in a plain texture, but not in a texture with uv_mapping or in
// a list of textures (spec 06 9.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.2, 0> angle 50 }
light_source { <-3, 8, -4>, rgb 1 }
plane { y, -1 pigment { rgb 0.9 } }
#declare Clear = pigment { gradient x pigment_map { [0.5 image_map { png "plasma2.png" filter all 0.8 }] } }
sphere { <-2.4, 0.4, 0>, 0.9 hollow texture { pigment { Clear } } }
sphere { <-0.8, 0.4, 1>, 0.7 hollow texture { uv_mapping pigment { Clear } } }
sphere { <0.8, 0.4, -0.6>, 0.7 hollow texture { checker texture { pigment { Clear } }, texture { pigment { rgb x } } } }
