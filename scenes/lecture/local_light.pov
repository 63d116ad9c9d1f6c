// A ball under one lamp: own light, diffuse reflection and a highlight, of which each can be turned.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ambient = 0.1;    // @range 0 1
#declare Diffuse = 0.7;    // @range 0 1
#declare Phong = 0.6;      // @range 0 1
#declare Phong_Size = 40;  // @range 1 200
camera { location <0, 1.2, -5> look_at <0, 0.9, 0> right 4/3*x angle 36 }
light_source { <4, 5, -3> rgb 1 }

sphere { <0, 1, 0>, 1 pigment { rgb <0.9, 0.35, 0.15> } finish { ambient Ambient diffuse Diffuse phong Phong phong_size Phong_Size } }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.45, 0.55, 0.65> scale 0.8 } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.85, 0.9, 0.95>] [1 rgb <0.35, 0.5, 0.75>] } } }
