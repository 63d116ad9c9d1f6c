// A quartic, a cubic and a sextic surface.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, -8.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 7.5, 0, 0, 0, 0, 1, 0, -8.5, 0, 14.0625>
  bounded_by { sphere { 0, 2.6 } } scale 0.7 rotate 50 * x translate <-2, 0.4, 0> pigment { rgb <0.8, 0.5, 0.4> }
}
cubic {
  <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -1>
  clipped_by { sphere { 0, 2 } } bounded_by { clipped_by } rotate 30 * y translate <0.3, 0.6, 2> pigment { rgb <0.5, 0.8, 0.4> }
}
polynomial {
  6, xyz(6, 0, 0): 1, xyz(0, 6, 0): 1, xyz(0, 0, 6): 1, xyz(0, 0, 0): -1
  bounded_by { box { -1.01, 1.01 } } rotate <15, 35, 0> translate <2.2, 0.2, 0> pigment { rgb <0.5, 0.5, 0.9> }
}
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
