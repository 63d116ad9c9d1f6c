// What is no number finds the first entry of a map, whatever the wave (spec 05 4.1).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0.5, 0> angle 60 }
#default { finish { ambient 1 diffuse 0 } }
plane { y, -1 pigment { function { sinh(x) * z - y } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } } }
sphere {
  <-1.5, 0.6, 0>, 0.9
  pigment { function { ln(y - 0.6) } sine_wave color_map { [0.2 rgb <1, 0.8, 0.2>] [0.7 rgb <0.2, 0.2, 0.6>] } }
}
sphere {
  <0.6, 0.6, 0>, 0.9
  texture {
    function { sqrt(x - 0.5) }
    texture_map { [0 pigment { rgb <0.2, 0.7, 0.9> }] [0.6 pigment { rgb <0.9, 0.3, 0.2> }] }
  }
}
box {
  <1.9, -0.4, 0>, <3.1, 1.2, 1>
  pigment { function { acos(x - 1.5) } pigment_map { [0.1 checker rgb 0 rgb 1 scale 0.2] [0.9 rgb <0.3, 0.6, 0.3>] } }
}
