// Vases, surfaces of revolution.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare Vase = sor { 9, <0.4, -0.2>, <0.5, 0>, <0.8, 0.5>, <0.6, 1.0>, <0.25, 1.4>, <0.22, 1.8>, <0.3, 2.1>, <0.5, 2.3>, <0.6, 2.5> open }
#for (I, -2, 2)
  #for (K, 0, 1)
    object { Vase translate <I * 1.5 + 0.4 * K, -1, 1.8 * K - 0.6> pigment { rgb <0.8 - 0.3 * K, 0.6, 0.4 + 0.1 * I> } }
  #end
#end
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
