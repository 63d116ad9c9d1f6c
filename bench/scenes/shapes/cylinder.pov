// A temple of columns.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#for (I, -4, 4)
  #for (K, 0, 3)
    cylinder { <I * 0.9, -1, K * 1.2 - 1>, <I * 0.9, 1.6, K * 1.2 - 1>, 0.25 pigment { rgb <0.8, 0.75, 0.6> } }
    cylinder { <I * 0.9, -1, K * 1.2 - 1>, <I * 0.9, -0.8, K * 1.2 - 1>, 0.38 pigment { rgb <0.7, 0.65, 0.5> } }
    cylinder { <I * 0.9, 1.5, K * 1.2 - 1>, <I * 0.9, 1.6, K * 1.2 - 1>, 0.38 pigment { rgb <0.7, 0.65, 0.5> } }
  #end
#end
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
