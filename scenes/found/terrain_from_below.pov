// Terrain that is seen from below through itself: where two of its facets are met at nearly the same place, the search
// for the next one ends at a hit that is too near to count, and there is nothing behind (spec 04, 5.2).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.5, 0, 0.5> look_at <0.8, 1, 0.7> right x * 0.01 up y * 0.0075 }
background { rgb x }
#declare Heights = function { 0.3 + 0.1 * sin(50 * x + 30 * y) + 0.1 * cos(70 * x - 57 * y) }
height_field {
  function 17, 17 { Heights(x, y, 0) } water_level 0.0001
  pigment { rgbt <0.5, 0.6, 0.7, 0.5> }
  finish { ambient 1 diffuse 0 }
}
