// A light has the box of what it looks like in the hierarchy that decides who wins of faces in the same place (spec 08 A).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 2, -6> angle 60 look_at <0, 0.5, 0> }
light_source { <-14, 8, -1>, 1 looks_like { sphere { 0, 0.5 pigment { rgb 1 } } } }
box { <-1, 0, -1>, <1, 1.5, 1> pigment { rgb 1 } scale <1, 2, 1> }
box { <-1, 0, -1>, <1, 1.5, 1> pigment { rgb x } }
