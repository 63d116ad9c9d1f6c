// Up to version 3.1 layers above the bottom one transmit what they were told to filter, and with them all that shares
// their maps, declared before or behind (spec 05 11.2).
#version 3.7;
#declare Layers = texture { pigment { rgbf <1, 0.5, 0, 0.7> } } texture { pigment { rgbf <0.5, 1, 0.3, 0.6> } }
#version 3.1;
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.3, 0.9> }
camera { location <0, 2.5, -6> look_at <0, 0.4, 0> angle 50 }
light_source { <5, 9, -5>, 1 }
#declare Map = color_map { [0 rgbf <1, 1, 0, 1>] [1 rgbf <0, 1, 1, 0.3>] }
#declare Cloud = pigment { bozo color_map { Map } scale 0.5 }
#declare Tiles = pigment { checker pigment { rgbf <1, 0, 0, 0.5> } pigment { rgbf <1, 1, 0, 0.8> } scale 0.3 }
sphere { <-1.8, 1, 0>, 0.7 pigment { gradient y color_map { Map } } }
box { <-2.5, -0.8, -0.5>, <-1.2, 0.2, 0.5> texture { pigment { Cloud } } texture { pigment { Cloud scale 2 } } }
box { <-0.7, -0.8, -0.5>, <0.6, 0.2, 0.5> texture { pigment { rgb <0.8, 0.1, 0.1> } } texture { pigment { Cloud } } }
box { <1.1, -0.8, -0.5>, <2.4, 0.2, 0.5> texture { pigment { rgb <0.1, 0.8, 0.1> } } texture { pigment { Tiles } } }
sphere { <0, 1, 0>, 0.7 pigment { Cloud } }
sphere { <1.8, 1, 0>, 0.7 pigment { Tiles } }
sphere { <0, -0.6, -1.5>, 0.4 texture { Layers } }
