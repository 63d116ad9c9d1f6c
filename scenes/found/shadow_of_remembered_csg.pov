// CSG with an opaque texture of its own and transparent parts: POV-Ray's shadow cache remembers the whole object and
// filters its light twice; objects without such a texture, and those in plain unions, filter once (spec 08 D).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -10> look_at <0, 0.5, 0> angle 42 }
light_source { <5, 20, -5>, 0.7 }
light_source { <-6, 15, 0>, 0.3 parallel point_at 0 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Glass = material {
  texture { pigment { rgb <1, 0.9, 0.8> transmit 0.75 } }
  interior { fade_power 1 fade_distance 0.5 fade_color <0.4, 0.6, 1> }
}
#macro Slab(X_Z) box { <-1.3, 1, -0.5>, <0, 1.2, 0.5> translate X_Z } #end
#macro Pane(X_Z) box { <0, 1, -0.5>, <1.3, 1.2, 0.5> material { Glass } translate X_Z } #end
#declare Left = <-1.8, 0, 0>;
#declare Right = <1.8, 0, 0>;
merge { Slab(Left) Pane(Left) pigment { rgb 0.5 } }
merge { object { Slab(Right) pigment { rgb 0.5 } } Pane(Right) }
union {
  Slab(Left - 2*z)
  Pane(Left - 2*z)
  clipped_by { plane { -y, 0 } }
  pigment { rgb <0.5, 0.3, 0.3> }
}
union { Slab(Right - 2*z) Pane(Right - 2*z) pigment { rgb <0.3, 0.5, 0.3> } }
difference {
  box { <-3, 1, 1.5>, <3, 1.3, 2.5> }
  box { <-1, 1.15, 0>, <9, 2, 3> material { Glass } }
  pigment { rgb <0.3, 0.3, 0.5> }
}
