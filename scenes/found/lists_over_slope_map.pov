// Lists of normals without any normals, where the default normal has a slope_map: it goes, and the numbers of the
// tiles are the heights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 5, 0> direction -y up z*4 right x*16/3 }
light_source { <3, 4, -6>, 1 }
#default { pigment { rgb 1 } normal { granite slope_map { [0 <0.5, 0>] [1 <0.5, 0>] } } }
#declare Place = box { <-0.8, -1, -0.6>, <0.8, 0, 0.6> }
object { Place normal { hexagon scale 0.3 } translate <-1.7, 0, 1.3> }
object { Place normal { triangular scale 0.4 } translate <0, 0, 1.3> }
object { Place normal { square scale 0.3 } translate <1.7, 0, 1.3> }
object { Place normal { checker scale 0.3 } translate <-1.7, 0, 0> }
object { Place normal { brick scale 0.1 } translate 0 }
object { Place normal { object { sphere { 0, 0.5 } } } translate <1.7, 0, 0> }
#declare Sloping = normal { bozo slope_map { [0 <0, 1>] [1 <0.2, -1>] } scale 0.2 }
#default { normal { hexagon scale 0.3 } }
object { Place normal { bozo } translate <-1.7, 0, -1.3> }
object { Place normal { Sloping } translate <0, 0, -1.3> }
object { Place normal { Sloping triangular scale 2 } translate <1.7, 0, -1.3> }
