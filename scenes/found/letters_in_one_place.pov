// Letters cut out of letters in the same place: whether points of the one's walls are inside the other (spec 04 9).
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { emission 1 diffuse 0 } }
camera { location <0.4, 0.9, -4> look_at <1.4, 0.4, 0.5> angle 50 }
#declare Letters = text { ttf "crystal.ttf" "AVR" 1, 0 }
difference { object { Letters pigment { rgb x } } object { Letters pigment { rgb y } } }
#declare Round = text { ttf "cyrvetic.ttf" "SR3" 1, 0 translate 0.8 * y }
intersection { object { Round pigment { gradient z } } object { Round pigment { rgb z } } }
