// A box of eggs.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#for (I, -2, 2)
  #for (K, 0, 2)
    ovus { 0.55, 0.3 rotate 12 * I * z translate <I * 1.3, 0, K * 1.3 - 0.8> pigment { rgb <0.9, 0.8 - 0.1 * K, 0.6> } }
  #end
#end
plane { y, -0.6 pigment { rgb <0.5, 0.6, 0.5> } }
