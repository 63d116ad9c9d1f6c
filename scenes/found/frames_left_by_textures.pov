// Normals lie in the frames of all patterned textures that were looked into before, also of those of other entries of
// the same map, of entries within entries and of what has no weight in an average (spec 05 10.1).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.6, 0> angle 45 }
light_source { <-4, 9, -7>, 0.9 }
plane { y, -0.6 pigment { rgb 0.8 } }
#declare Plain = texture { pigment { slope { y } color_map { [0 rgb x] [1 rgb 1] } } normal { bumps 0.6 scale 0.3 } };
#declare Long = texture { cells texture_map { [0 pigment { rgb <0.4, 0.6, 1> }] } scale <1, 3, 1> };
#declare Turned = texture { cells texture_map { [0 Plain] } rotate 40 * z scale <0.5, 1, 1> };
#declare Within = texture { wood texture_map { [0 Long] [1 Turned] } scale 1.5 };
sphere { <-2.4, 0.4, 0>, 1 texture { gradient y texture_map { [0 Plain] [1 Long] } scale 2 translate -y } }
sphere { <0, 0.4, 0>, 1 texture { average texture_map { [1 Turned] [2 Within] [1 Plain] } } }
sphere { <2.4, 0.4, 0>, 1 texture { average texture_map { [0 Long] [1 Plain] } } }
#declare Glass = texture { pigment { rgbf 0.9 } normal { bumps 0.8 scale 0.3 } };
disc {
  <0, 3, -1>, y, 1.5
  texture { average texture_map { [1 cells texture_map { [0 Glass] } scale <1, 1, 4>] [1 Glass] } }
  interior { caustics 1 }
}
