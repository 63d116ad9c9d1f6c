// A cylinder with a radius of 0 has no surface, but holds all that lies between its caps (spec 03 4.3): what it is merged
// with is not seen there, and what is cut by it keeps that part only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 }
light_source { <-50, 80, -100>, 1 }
background { rgb 0.3 }
#declare Thread = cylinder { <-2, 0, -1>, <0, 1, 0>, 0 }
merge { sphere { 0, 1 } object { Thread } pigment { rgb <1, 0.6, 0.4> } translate <-2.4, 1, 0> }
merge { sphere { 0, 1 } difference { object { Thread } } pigment { rgb <0.6, 1, 0.4> } translate <0, 1, 0> }
intersection { sphere { 0, 1 } object { Thread } pigment { rgb <0.4, 0.6, 1> } translate <2.4, 1, 0> }
difference { torus { 0.8, 0.3 } object { Thread } pigment { rgb <1, 0.6, 1> } translate <-2, -1.2, 0> }
difference { box { -0.9, 0.9 } cylinder { -y/2, y/2, 0 open } pigment { rgb <1, 1, 0.4> } translate <1.5, -1.2, 0> }
