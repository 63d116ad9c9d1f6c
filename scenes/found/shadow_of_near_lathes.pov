// Lathes and a sor of glass so near to the floor that shadow rays begin beyond their undersides: outside CSG the far
// sides are lost with these, and light comes through; in a merge they filter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 5*y direction -y up 3*z right 4*x }
light_source { <1, 50, 2>, 1 }
plane { y, 0 pigment { rgb 1 } }
#declare Glass = texture { pigment { rgbf <0.6, 0.7, 0.8, 0.9> } }
#declare Bowl = lathe { linear_spline 4, <0, 0>, <0.6, 0>, <0.8, 1>, <0, 1.5> texture { Glass } translate 0.0003*y }
object { Bowl translate <-1, 0, 0.7> }
merge {
  object { Bowl translate <1, 0, 0.7> }
  sphere { <1, 1.4, 0.7>, 0.1 }
  texture { Glass }
}
lathe {
  cubic_spline 6, <-0.3, 0.1>, <0, 0>, <0.3, 0.002>, <0.7, 0.5>, <0, 1.5>, <-1, 2>
  texture { Glass }
  translate <-1, 0.0003, -0.7>
}
sor { 6, <0, 0>, <0.2, 0>, <0.7, 0.002>, <0.5, 1>, <0, 2>, <0, 2> texture { Glass } translate <1, 0, -0.7> }
