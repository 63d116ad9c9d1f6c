// atmosphere: rainbow
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 1.7, 0> angle 60 }
light_source { <-30, 60, -20> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [0.6 rgb <0.2, 0.4, 0.9>] } } } rainbow { angle 30 width 8 distance 30 direction <0, -0.25, 1> color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [0.5 rgbt <0.1, 0.9, 0.2, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } }
plane { y, 0 pigment { checker rgb 0.7, rgb <0.3, 0.45, 0.25> scale 1.5 } }
#declare I = 0;
#while (I < 6)
  cylinder { <-2.2, 0, I*5>, <-2.2, 2.6, I*5>, 0.3 pigment { rgb <0.8, 0.3, 0.2> } }
  sphere { <2.4, 0.9, I*5 - 1>, 0.7 pigment { rgb <0.3, 0.4, 0.8> } finish { reflection 0.4 } }
  #declare I = I + 1;
#end
box { <-0.7, 0.2, 1>, <0.7, 1.8, 1.1> pigment { rgbt <1, 1, 1, 0.8> } finish { reflection 0.2 } hollow }
