// Dispersion: a ruler of brightness 0.25 + x / 12 behind three prisms of BK7, for the lines C (front), d and F (back): n = 1.51432, 1.51680 and 1.52238.
// Rays enter at right angles and leave through a face that is turned by 30 degrees: sin(b) = n sin(a).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 6*y direction -y right 4*x up 3*z }
plane {
  y, -4
  pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 12 translate -3*x }
  finish { ambient 0 diffuse 0 emission rgb 1 }
}
#macro Prism(Index, Z)
  intersection {
    plane { y, 2 }
    plane { -y, 0 rotate 30*z }
    box { <-3, -3, Z - 0.5>, <3, 3, Z + 0.5> }
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior Index }
  }
#end
Prism(1.51432, -1)
Prism(1.51680, 0)
Prism(1.52238, 1)
