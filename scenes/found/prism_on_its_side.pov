// A prism that lies with a wall in the floor: the last digits of depths decide which is seen (spec 08 B).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-2, 3, 6> look_at <0.5, 0.2, 0> }
light_source { <-5, 9, 6>, 1 }
plane { y, 0 pigment { checker rgb 1 rgb 0.6 } }
prism { 0, 1, 4, <-1, 0>, <1, 0>, <0, -1.3>, <-1, 0> rotate 90*x translate <-0.7, 0, 1.5> pigment { rgbt <1, 0, 0, 0.3> } }
prism { 0, 1.5, 5, <-1, 0>, <1, 0>, <0.8, -0.9>, <-0.5, -1>, <-1, 0> rotate <90, 25, 0> translate <1.6, 0, -0.5> pigment { rgbt <0, 0.4, 1, 0.5> } }
