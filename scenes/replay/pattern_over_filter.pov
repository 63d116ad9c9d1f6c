// A pattern that takes the place of a pigment that lets light through: what it covers is dark, but it is not remembered
// as what blocked the light last, for its solid colour is there still.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 5, -11> look_at y angle 20 }
light_source { <1, 32, -18>, 1 }
cylinder { <0.5, 0, -2.75>, <0.5, 1.5, 0>, 0.3 rotate 100*z }
#declare Goblet = lathe {
  linear_spline 4, <0, 0>, <0.3, 0.2>, <0.4, 1>, <0, 1.5>
  pigment { rgbt <1, 1, 1, 0.7> }
  finish { diffuse 0.6 }
}
object { Goblet pigment { marble } }
object { Goblet }
