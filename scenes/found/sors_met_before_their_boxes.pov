// Rays that hardly rise meet a sor in front of itself and of its box, by the rounding of its formula. Of two in one
// place then the one whose turn comes first is seen: the other's box lies beyond the hit.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-0.01365303678394467, 0.00527549237953228, -5> look_at 0 right 5*x up 3.75*y }
light_source { -10*z, 0.8 }
#declare Vase = sor { 5 <0, -1> <0.5, -0.8> <1, 0> <0.3, 0.8> <0, 1> }
object { Vase pigment { rgb 1 } }
object { Vase pigment { rgb x } }
box { <-1.5, -1.6, -1>, <1.3, 1.2, 1> pigment { rgb y } }
box { <-2, -2, 0>, 2 pigment { rgb z } }
