// A plane or polynomial that is moved with what holds it takes the box of its first clip (spec 03 2.2): what stands in
// its place is asked before it or after it by that, and where the clip is inverted it is seen within that box only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <1, 2, -10> look_at 0 right 16*x up 12*y }
#default { finish { ambient 1 diffuse 0 } }

#macro Pair(Shape)
  union { object { Shape pigment { rgb x } } sphere { <0, 1.4, 0>, 0.2 pigment { rgb 1 } } rotate 0*y }
  merge { object { Shape } sphere { <0, -1.4, -0.55>, 0.2 } rotate 0*y pigment { rgb y } }
#end
#declare First = box { <-0.9, -0.9, -0.5>, 0.9 }
#declare Second = box { <-1, -1, -0.9>, 1 }
#declare A = plane { <0.3, 1, -1>, 0 clipped_by { First } }
#declare B = plane { <0.3, 1, -1>, 0 clipped_by { First Second } }
#declare C = plane { <0.3, 1, -1>, 0 clipped_by { Second First } }
#declare D = cubic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0> clipped_by { First } }
#declare E = plane { -z, 0 clipped_by { plane { -z, 0.5 } First } }
#declare F = quadric { 1, 0, 0, -1 clipped_by { First } }
union { Pair(A) translate <-5, 3, 0> }
union { Pair(B) translate <-2, 3, 0> }
union { Pair(C) translate <1, 3, 0> }
union { Pair(D) translate <4, 3, 0> }
union { Pair(E) translate <-5, -1, 0> }
union { Pair(F) translate <-2, -1, 0> }

// Seen within the box of what is cut out of it.
union {
  plane { z, 3 clipped_by { box { <1, -3, -2>, <5, 1, -1> inverse } } pigment { checker rgb 0.3 rgb 0.6 } }
  sphere { <3, -1, 0>, 0.5 pigment { rgb z } }
  rotate 0*y
}
