// A chain of rings.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#for (I, 0, 6)
  #for (K, -1, 1)
    torus { 0.62, 0.17 rotate 90 * mod(I, 2) * x rotate 20 * y rotate 15 * z translate <(I - 3) * 0.95, 0.3, K * 1.6 + 0.6> pigment { rgb <0.8, 0.7 - 0.1 * K, 0.3> } }
  #end
#end
torus { 2.6, 0.35 translate -0.8 * y pigment { rgb <0.4, 0.5, 0.8> } }
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
