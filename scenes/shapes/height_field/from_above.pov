// Height fields seen straight from above: rays go down but for the rounding of a rotation.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.013, 0.007, -100> right 16*x up 12*y look_at <0.013, 0.007, 0> }
background { rgb <0.1, 0.2, 0.3> }
light_source { <30, 50, -100>, rgb 1 }
height_field { function 4, 4 { 0.5 } rotate -90*x scale <4, 3, 1> translate <-2, -1.5, 0> pigment { rgb <1, 0.6, 0.4> } }
height_field { function 16, 16 { x } smooth rotate -90*x scale <4, 3, 1> translate <-7, -1.5, 0> pigment { rgb <0.5, 1, 0.4> } }
height_field { function 40, 30 { 0.5 + 0.4*sin(9*x)*cos(7*y) } rotate -90*x scale <4, 3, 1> translate <3, -1.5, 0> pigment { rgb <0.5, 0.6, 1> } }
height_field { function 40, 30 { 0.5 + 0.4*sin(9*x)*cos(7*y) } water_level 0.4 rotate -90*x scale <9, 3, 1> translate <-4, 2, 0> pigment { rgb <1, 1, 0.4> } }
