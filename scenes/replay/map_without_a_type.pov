// A pigment of a map and no type is black, but the map's transparency keeps its object from being flagged as opaque:
// where two boxes share a face, the black one takes the light from the other one's only if it is flagged, as the right
// ones of the upper row and of the lower row are.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> up 3*y right 4*x }
light_source { <5, 5, -5>, 1 }
#macro Half() box { <0, -1, 0>, <1, 1, 1> #end
#macro Other_Half(Place)
    }
    box { -1, 1 pigment { rgbt <1, 0.5, 0.2, 0.5> } }
    rotate <10, 40, 0>
    scale 0.4
    translate Place
  }
#end
union { Half() pigment { color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0>] } } Other_Half(<-1.2, 0.7, 0>)
union { Half() pigment { pigment_map { [0 rgbt 1] [1 rgb 1] } scale 2 } Other_Half(<0, 0.7, 0>)
union { Half() pigment { color_map { [0 rgb 1] [1 rgb <1, 0, 0>] } } Other_Half(<1.2, 0.7, 0>)
#default { pigment { color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0>] } } }
union { Half() Other_Half(<-1.2, -0.7, 0>)
union { Half() pigment { rgb 0 } Other_Half(<0, -0.7, 0>)
union { Half() pigment { color_map { [0 rgb 0] [1 rgb 0.1] } } Other_Half(<1.2, -0.7, 0>)
