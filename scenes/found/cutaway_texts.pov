// Texts that are inverted, as in a difference, show what they are cut out of under cutaway_textures; others have the
// default texture (spec 03 5.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 40 }
#default { pigment { rgb <0.2, 0.3, 0.9> } finish { ambient 0.4 diffuse 0.6 } }
light_source { <-3, 5, -9>, rgb 1 }
#declare Letters = text { ttf "cyrvetic.ttf" "OH" 3, 0 translate <-0.7, -0.3, -2> }
#declare Body = sphere { 0, 0.8 pigment { gradient y color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } } }
difference { object { Body } object { Letters } cutaway_textures translate -0.9 * x }
intersection { object { Body } object { Letters } cutaway_textures scale 0.6 translate <0.6, 0.55, 0> }
difference { object { Body } union { object { Letters } } cutaway_textures scale 0.6 translate <0.6, -0.55, 0> }
