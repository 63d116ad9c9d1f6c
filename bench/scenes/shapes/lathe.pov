// Chessmen turned from cubic and Bezier splines.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare Pawn = lathe { cubic_spline 9, <0.6, -0.2>, <0.6, 0>, <0.5, 0.2>, <0.25, 0.5>, <0.2, 0.9>, <0.35, 1.05>, <0.3, 1.4>, <0, 1.6>, <-0.3, 1.4> }
#declare Vase = lathe { bezier_spline 8, <0.5, 0>, <0.9, 0.5>, <0.2, 1.0>, <0.2, 1.4>, <0.2, 1.4>, <0.2, 1.6>, <0.5, 1.7>, <0.5, 1.9> }
#for (I, -2, 2)
  object { Pawn translate <I * 1.4, -1, -0.8> pigment { rgb <0.8, 0.7, 0.5> } }
  object { Vase translate <I * 1.4 + 0.3, -1, 1.4> pigment { rgb <0.4, 0.5, 0.8> } }
#end
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
