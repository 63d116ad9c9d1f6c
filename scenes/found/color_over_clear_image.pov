// A pigment in which an image_map with `filter` or `transmit` was ever written is not flagged opaque, whatever has taken
// the place of the image: of two spheres in one place the clear one is met first, and light passes (spec 06 9.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 100 }
light_source { <5, 5, -5>, rgb <1, 0.9, 0.7> }
#default { pigment { image_map { png "plasma2.png" filter all 0 } } }
box { <-0.2, -0.2, 0.2>, 0.6 pigment { rgbt 0.5 } }
sphere { 0, 1 pigment { rgb 1 } }
sphere { 0, 1 pigment { rgbt 0.5 } }
plane { y, -1 pigment { rgb 1 } }
