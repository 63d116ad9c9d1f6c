// Material maps of opaque textures are flagged opaque as layers are, other maps of textures are not: CSG with one is
// remembered as a blocker and filters twice, and a blob that had one when its statement ended blocks all light (spec 06
// 9.3, 08 D).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> look_at <0, 0.4, 0> angle 45 }
light_source { <-4, 9, -7>, 0.8 }
plane { y, -1 pigment { rgb 1 } }
#declare Flat = texture { pigment { rgb <0.5, 1, 1> } };
#declare Striped = texture { gradient x texture_map { [0 pigment { rgb x }] [1 Flat] } };
#macro Cut(Entry, Place)
  difference {
    box { -1, 1 }
    sphere { 0, 1.2 pigment { rgbf <1, 0.9, 0.8, 0.8> } }
    texture { material_map { function 4, 4 { x } texture { Entry } texture { Flat } } }
    scale 0.9
    translate Place
  }
#end
Cut(Flat, -2.2 * x)
Cut(Striped, 0)
#declare Former = blob {
  threshold 0.3
  sphere { 0, 1.2, 1 texture { material_map { function 4, 4 { x } texture { Flat } } } }
  sphere { x, 1, 1 }
  pigment { rgb 1 }
};
object { Former pigment { rgbf 0.8 } translate 1.8 * x }
