// Planes, discs, polygons and triangles.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#for (I, 0, 11)
  disc { <2.6 * cos(I * pi / 6), 0.2, 2 * sin(I * pi / 6)>, <cos(I), 1, -1>, 0.6, 0.2 pigment { rgb <0.9, 0.7 - 0.04 * I, 0.3> } }
  polygon { 6, <0, 1>, <0.95, 0.3>, <0.6, -0.8>, <-0.6, -0.8>, <-0.95, 0.3>, <0, 1> scale 0.5 rotate <-30, 40 * I, 0> translate <1.6 * cos(I * pi / 6), 1.3, 1.4 * sin(I * pi / 6)> pigment { rgb <0.3, 0.5 + 0.04 * I, 0.8> } }
  triangle { <cos(I), -0.9, -2>, <cos(I) + 0.7, -0.6, -1.8>, <cos(I) + 0.3, 0, -2.2 + 0.1 * I> pigment { rgb <0.4, 0.8, 0.4> } }
#end
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
plane { -z, -6 pigment { rgb <0.6, 0.7, 0.9> } }
