// A brick that follows a brick keeps its sizes, also after an identifier; another pattern in between forgets them (spec 08 E).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

#declare Wall = pigment { brick rgb 1 rgb x brick_size 0.3 mortar 0.05 }
box { <-2, -0.5, 0>, <-1, 0.5, 1> pigment { brick rgb x rgb y brick_size <0.3, 0.2, 0.3> mortar 0.03 } pigment { brick rgb z rgb <1, 0, 1> } }
box { <-0.5, -0.5, 0>, <0.5, 0.5, 1> pigment { Wall brick rgb 0.1 rgb <1, 1, 0> } }
box { <1, -0.5, 0>, <2, 0.5, 1> pigment { Wall } pigment { checker } pigment { brick rgb 0.1 rgb <0, 1, 1> scale 0.1 } normal { brick 0.5 brick_size 0.2 mortar 0.05 } normal { brick 0.4 } }
