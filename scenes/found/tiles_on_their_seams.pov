// Tilings 12 to 14 have no tiles on the lines between their cells (spec 05 9.1), where all of a surface may lie that has
// uv coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -6> look_at <0, 0.7, 0> angle 42 }
light_source { <5, 9, -6>, 1 }
#declare Map = color_map { [0 rgb <0.9, 0.8, 0.5>] [0.5 rgb <0.5, 0.2, 0.1>] [1 rgb <0.1, 0.3, 0.6>] }
box { <-2.2, 0, 0>, <-0.8, 1.5, 1> texture { uv_mapping pigment { tiling 12 color_map { Map } } } }
box { <-0.7, 0, 0>, <0.7, 1.5, 1> texture { uv_mapping pigment { tiling 13 color_map { Map } } } }
box { <0.8, 0, 0>, <2.2, 1.5, 1> texture { uv_mapping pigment { tiling 14 color_map { Map } } } }
plane { -z, -4 texture { pigment { rgb 0.7 } normal { tiling 13 rotate 90 * x } } }
plane { y, -0.3 texture { pigment { rgb 0.7 } normal { tiling 14 rotate -90 * x translate y } } }
plane { x, -4 texture { pigment { tiling 14 color_map { Map } rotate 90 * z translate -4 * x } } }
