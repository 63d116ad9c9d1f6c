// Solids that share faces: which of them is seen follows from POV-Ray's bounding hierarchy (spec 08 A).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <4, 5, -9> look_at <0, 1, 0> angle 40 }
light_source { <5, 9, -12>, 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb 0.6 } }
#declare I = 0;
#while (I < 7)
  box { <I - 4, 0, -1>, <I - 2, 1 + mod(I, 3), 1> pigment { rgb <mod(I, 2), mod(I, 3)/2, mod(I, 5)/4> } }
  #declare I = I + 1;
#end
union {
  box { <-2, 0, -2>, <0, 1, 0> }
  box { <-1, 0, -2>, <1, 2, -1> }
  pigment { rgb <1, 0.8, 0.2> }
}
cylinder { <2, 0, -2>, <2, 1, -2>, 0.6 pigment { rgb <0.2, 0.8, 0.8> } }
difference { box { <1, 0, -3>, <3, 1, -2> } box { <2, 0.5, -3>, <3, 1, -2> } pigment { rgb <0.8, 0.2, 0.6> } }
