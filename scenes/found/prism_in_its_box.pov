// Prisms cut by boxes with faces in the same place: points in the edges of an outline are inside on its right
// (spec 03 4.17).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 2.5, -5> look_at 0 angle 50 }
light_source { <3, 5, -5>, 1 }
#declare Wedge = difference {
  prism { linear_spline -1, 0.5, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> pigment { rgb <1, 0.7, 0.3> } }
  box { <0, -1, 0>, <1, 0, 1> pigment { rgb 1 } }
}
#for (I, 0, 3)
  object { Wedge rotate 90*I*y translate <1.2*I - 1.8, 0, 0> }
#end
