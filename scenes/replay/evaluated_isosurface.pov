// What the last search for an isosurface missed is compared with the slope that was in force before this search makes it
// smaller (spec 04 6.4).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 2, -7> look_at <0, 0.5, 0> }
light_source { <3, 5, -6>, 1 }
isosurface { function { abs(x) + abs(y) + abs(z) - 1 } evaluate 1, 1.2, 0.9 pigment { rgb <1, 0.7, 0.3> } finish { ambient 0.3 } }
isosurface {
  function { abs(x) + abs(y) + abs(z) - 1 } max_gradient 0.4 evaluate 0.1, 1, 1.3
  pigment { rgb <0.3, 0.7, 1> } finish { ambient 0.3 } translate <2.2, 0.5, 0>
}
