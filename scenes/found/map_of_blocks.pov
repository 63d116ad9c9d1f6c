// The colours that checker, brick and hexagon have without any being written stay as the map of a later pattern (spec 05 4.3).
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 8 }
camera { location <0, 1, -6> }
#default { pigment { checker } }
#declare Bricks = pigment { brick }
#declare Cells = pigment { hexagon scale 2 }
sphere { <-1.6, 0.5, 0>, 1 pigment { bozo scale 0.3 } }
sphere { <0.6, 0.5, 0>, 1 pigment { Bricks gradient y } }
sphere { <2.6, 0.5, 0>, 0.9 pigment { Cells function { y - floor(y) } } }
plane { y, -1 pigment { marble scale 0.6 } }
