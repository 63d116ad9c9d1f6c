// Normals of a map are blended in double precision: mirrors before a backdrop whose grains are 1e-8 wide.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.1, 1.3, -4> look_at <0.2, 0.1, 0> }
box { -9, 9 hollow pigment { function { mod(abs(x + y + z) * 1e8, 1) > 0.5 } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
plane { y, -0.3 pigment { rgb 0 } normal { gradient x normal_map { [0.15 gradient z 0.4 scale 0.5] [0.4 gradient x 0.2] [0.75 leopard 0.4 scale 0.3] } } finish { ambient 0 diffuse 0 reflection 1 } }
