// POV-Ray says that patches cannot be inverted, but turns meshes over: what was their front shows the interior_texture.
// They still have no inside (spec 04 1.6).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.1, 0.2, -5> right 16 / 3 * x up 4 * y look_at 0 }
#default { finish { ambient 1 diffuse 0 } }
#declare Flat = mesh {
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> }
  texture { pigment { rgb x } }
  interior_texture { pigment { rgb y } }
}
#declare Bent = mesh {
  smooth_triangle { <-1, -1, 0>, <0.2, -1, -3>, <1, -1, 0>, <1, -1, -3>, <0, 1, 0>, <0, 1, -3> }
  texture { pigment { rgb x } }
  interior_texture { pigment { rgb y } }
}
#declare Ball = sphere { 0, 0.8 pigment { rgb z } }
object { Flat inverse scale 0.5 translate <-2, 1, 0> }
object { Bent inverse scale 0.5 rotate 10 * z translate <-0.7, 1, 0> }
union { object { Flat } inverse scale 0.5 translate <0.7, 1, 0> }
#declare Turned = object { Bent inverse }
object { Turned inverse scale 0.5 translate <2, 1, 0> }
difference { object { Ball } object { Flat } scale 0.8 translate <-1.8, -1, 0> }
intersection { object { Ball } object { Flat inverse } scale 0.8 translate -y }
merge { object { Ball } object { Flat inverse } scale 0.8 translate <1.8, -1, 0> }
