// The flags of texts count in intersections and differences, as those of the letters they are unions of (spec 03 5.5).
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { emission 0.8 diffuse 0 } }
camera { location <0, 0, -6> look_at 0 angle 60 }
sky_sphere { pigment { gradient x color_map { [0 rgb 0] [1 rgb z] } } }
plane { y, -1.2 pigment { checker rgb 0.3, rgb 0.6 } finish { reflection 0.5 } }
#declare Letters = text { ttf "crystal.ttf" "O8" 1, 0.1 * x no_reflection scale 1.4 pigment { rgb <0.5, 0.1, 0> } finish { reflection 0.5 } normal { bumps 0.5 } }
#declare Block = box { <-3, 0.3, -2>, <3, 1, 2> pigment { rgb <0, 0.4, 0> } finish { reflection 0.5 } }
difference { object { Letters } sphere { <0.8, 0.9, 0.4>, 0.4 pigment { rgb y } } translate -2.4 * x }
intersection { object { Letters } object { Block } translate -0.6 * x }
intersection { object { Letters inverse } object { Block } scale 0.4 translate 2 * y }
intersection { object { Letters inverse inverse no_image } object { Block } translate 1.2 * x }
