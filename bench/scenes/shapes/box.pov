// A spiral stair of turned boxes around a pillar.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#for (I, 0, 59)
  box { <0.4, 0, -0.3>, <2.4, 0.12, 0.3> rotate -24 * I * y translate <0, 0.075 * I - 1, 0> pigment { rgb <0.8, 0.7 - I * 0.006, 0.4> } }
#end
box { <-0.4, -1, -0.4>, <0.4, 4, 0.4> pigment { rgb 0.7 } }
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
