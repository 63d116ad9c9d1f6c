// An image is remembered as what blocked the light last if none of its pixels lets light through: an alpha channel that
// is opaque everywhere does not count.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 8, -6> look_at 0 }
plane { y, 0 pigment { checker rgb 1 rgb 0.3 } }
light_source { <2, 5, -24>, 1 }
sphere { <-1, 0, -1>, 2 pigment { rgb 1 } }
sphere { <-1, 0, -1>, 2 pigment { rgbt 0.5 } }
sphere {
  <-1, 0, -1>, 2
  rotate 200 * y
  pigment { image_map { function 16, 16 { pigment { checker rgbt <0.4, 0.5, 0.9, 0> rgb 0.8 scale 0.25 } } } rotate 90 * x scale 4 translate -2 }
}
