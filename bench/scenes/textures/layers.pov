// Layered textures: rust over metal, clouds over a planet.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1, 0> angle 50 }
light_source { <-20, 30, -30> rgb 1 }
#declare Rust = texture { pigment { granite turbulence 0.3 color_map { [0 rgb <0.4, 0.2, 0.1>] [0.4 rgbt <0.6, 0.3, 0.1, 0.5>] [0.6 rgbt 1] [1 rgbt 1] } scale 0.6 } }
plane { y, 0 texture { pigment { bozo scale 3 color_map { [0 rgb 0.5] [1 rgb 0.7] } } } texture { Rust scale 2 } }
sphere { <-1.6, 1.3, 0>, 1.3
  texture { pigment { bozo turbulence 0.6 scale 0.7 color_map { [0 rgb <0, 0.1, 0.5>] [0.5 rgb <0, 0.2, 0.6>] [0.5 rgb <0.2, 0.5, 0.1>] [1 rgb <0.5, 0.4, 0.2>] } } }
  texture { pigment { wrinkles turbulence 0.4 scale <1, 0.4, 1> color_map { [0 rgbt 1] [0.5 rgbt 1] [0.8 rgbt <1, 1, 1, 0.2>] [1 rgb 1] } } } }
box { <0.4, 0, -1>, <2.6, 2, 1> texture { pigment { rgb <0.7, 0.7, 0.75> } normal { bumps 0.2 scale 0.05 } finish { specular 0.8 } } texture { Rust } }
