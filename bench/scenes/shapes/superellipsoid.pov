// Soft dice and stars.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#for (I, 0, 3)
  #for (K, 0, 2)
    superellipsoid { <0.15 + 0.55 * I, 0.2 + 0.6 * K> scale 0.62 rotate <20, 30 * I, 10> translate <I * 1.5 - 2.25, 0, K * 1.6 - 0.6> pigment { rgb <0.3 + 0.2 * I, 0.6, 0.3 + 0.3 * K> } }
  #end
#end
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
