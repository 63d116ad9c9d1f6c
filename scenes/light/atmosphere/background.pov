// atmosphere: background
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 1.7, 0> angle 60 }
light_source { <-30, 60, -20> rgb 1 }
background { rgb <0.4, 0.6, 0.8> }
plane { y, 0 pigment { checker rgb 0.7, rgb <0.3, 0.45, 0.25> scale 1.5 } }
#declare I = 0;
#while (I < 6)
  cylinder { <-2.2, 0, I*5>, <-2.2, 2.6, I*5>, 0.3 pigment { rgb <0.8, 0.3, 0.2> } }
  sphere { <2.4, 0.9, I*5 - 1>, 0.7 pigment { rgb <0.3, 0.4, 0.8> } finish { reflection 0.4 } }
  #declare I = I + 1;
#end
box { <-0.7, 0.2, 1>, <0.7, 1.8, 1.1> pigment { rgbt <1, 1, 1, 0.8> } finish { reflection 0.2 } hollow }
