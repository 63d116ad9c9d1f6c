#version 3.1;
camera { location <0,0,-5> look_at 0 right <4/3,0,0> }
background { color rgb <1,1,1> }
sky_sphere { pigment { gradient y color_map { [0.0 color blue 1] [1.0 color rgb 1] } scale 2 translate -1 } }
plane { y, -1 pigment { checker color rgb 1 color rgb 0 } }
