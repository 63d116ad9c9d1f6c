// Two surfaces of one solid that a ray meets in the same place, in its edges: within CSG the one that is found first is
// seen, alone the last. Every tenth of a unit there is a pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.05, 0.05, -20> right 16*x up 12*y }
#default {
  pigment { slope <-0.6, 0.64, 0.48> color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } }
  finish { ambient 1 diffuse 0 }
}
#declare Cone = cone { -y, 1, y, 0.5 }
#declare Tent = prism { conic_sweep linear_spline 0, 1, 5 <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }
#declare House = prism { linear_spline -1, 1, 5 <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }
#declare Land = height_field { png "plasma2.png" translate -0.5 scale 2 }
#macro Row(Y, Solid)
  object { Solid translate <-4.5, Y, 0> }
  intersection { object { Solid } box { -9, 9 } translate <-1.5, Y, 0> }
  merge {
    intersection { merge { object { Solid } sphere { 9, 1 } } box { -9, 9 } }
    sphere { 9, 0.5 }
    translate <1.5, Y, 0>
  }
  difference { intersection { object { Solid } box { -9, 9 } } box { <0, 0, -9>, 9 } translate <4.5, Y, 0> }
#end
Row(4.4, Cone)
Row(1.5, Tent)
Row(-1.5, House)
Row(-4.4, Land)
