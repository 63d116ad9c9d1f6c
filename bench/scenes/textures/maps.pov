// Maps in maps: tiles of pigment maps, an averaged pigment, a textured list.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> look_at <0, 0.8, 0> angle 45 }
light_source { <-20, 30, -30> rgb 1 }
#declare Veined = pigment { marble turbulence 0.8 color_map { [0 rgb 1] [1 rgb <0.3, 0.4, 0.5>] } scale 0.7 }
#declare Speckled = pigment { granite color_map { [0 rgb <0.2, 0.15, 0.1>] [1 rgb <0.9, 0.85, 0.8>] } scale 0.5 }
plane { y, 0 texture { checker texture { pigment { Veined } finish { specular 0.3 } } texture { pigment { Speckled } } } }
sphere { <-1.6, 1.3, 0>, 1.3 pigment { gradient y turbulence 0.3 pigment_map { [0.3 Veined] [0.6 Speckled] } } }
sphere { <1.6, 1.3, 0>, 1.3 pigment { average pigment_map { [1 Veined] [1 Speckled] [0.5 bozo scale 0.3] } } }
