// A blob blocks all light if its texture does, whatever its interior_texture lets out: also where both come from the
// CSG around it. Light from above goes through the tops of these from within.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, -0.3, 0> angle 45 }
light_source { <0, 9, 2>, 1 }
#macro Ball(X) blob { threshold 0.5 sphere { <X, 0, 0>, 2.2, 1 } #end
#macro Skins()
  texture { pigment { rgb <1, 0.5, 0> } }
  interior_texture { pigment { rgbt <1, 1, 0.5, 0.7> } }
  clipped_by { plane { -z, 0.5 } }
#end
difference { Ball(-2.5) } sphere { 9, 1 } Skins() }
merge { merge { Ball(0) } sphere { 1.5*y, 0.3 } } sphere { 9, 1 } Skins() }
Ball(2.5) Skins() }
