// Steep smooth terrain in the light of a low sun: a facet that turns away from the light is lit through its smooth
// normal where the next facet is too near to count, since the search ends there (spec 04, 5.2).
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <-2, 20, -20> look_at 0 angle 30 }
light_source { 1000, 1.5 }
height_field {
  function 513, 513 { 0.5 + 0.2 * sin(9 * x) * cos(7 * y) + 0.6 * (f_noise3d(170 * x, 170 * y, 0) - 0.5) }
  smooth
  pigment { rgb 1 }
  finish { ambient 0.1 diffuse 0.6 }
  translate -0.5
  scale <20, 3, 10>
}
