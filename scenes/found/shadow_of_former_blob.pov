// What the pigment of a blob was when its statement ended decides whether it blocks light: whatever `pigment` makes of
// it in a copy, unless an identifier replaces it (spec 06 9.3). Components that may filter, or have a map of textures,
// let light through with the rest.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9, -9> look_at <0, 0, 0.5> angle 50 }
light_source { <4, 20, -6>, 1 }
plane { y, -1.2 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
#declare Tint = rgbf <0.9, 0.6, 0.4, 0.8>;
#declare Glass = pigment { Tint }
#declare Opaque = blob { sphere { <-0.5, 0, 0>, 1, 1 } sphere { <0.6, 0, 0>, 1, 1 } threshold 0.4 pigment { rgb x } }
#declare Shiny = blob { sphere { <-0.5, 0, 0>, 1, 1 } sphere { <0.6, 0, 0>, 1, 1 } threshold 0.4 finish { phong 1 } }
#declare Bare = blob { sphere { <-0.5, 0, 0>, 1, 1 } sphere { <0.6, 0, 0>, 1, 1 } threshold 0.4 }
#declare Mapped = blob {
  sphere { <-0.5, 0, 0>, 1, 1 }
  sphere { <0.6, 0, 0>, 1, 1 texture { checker texture { pigment { rgb x } } texture { pigment { rgb y } } } }
  threshold 0.4
  pigment { rgb x }
}
#declare Mixed = blob {
  sphere { <-0.5, 0, 0>, 1, 1 pigment { rgbf 0.7 } }
  sphere { <0.6, 0, 0>, 1, 1 }
  threshold 0.4
  pigment { rgb x }
}
#declare Again = object { Opaque pigment { rgbf 0.5 } }
object { Opaque pigment { Tint } translate <-2.6, 0, 2.5> }
object { Opaque pigment { Glass } translate <0, 0, 2.5> }
object { Again pigment { Tint } translate <2.6, 0, 2.5> }
object { Shiny pigment { Tint } translate <-2.6, 0, 0> }
object { Bare pigment { Tint } translate 0 }
object { Mapped pigment { Tint } translate <2.6, 0, 0> }
object { Mixed pigment { Tint } translate <-2.6, 0, -2.5> }
blob { Bare pigment { Tint } translate <0, 0, -2.5> }
