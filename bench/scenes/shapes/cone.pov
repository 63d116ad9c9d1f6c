// A wood of firs, three cones each.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare R = seed(3);
#for (I, 1, 60)
  #declare P = <rand(R) * 9 - 4.5, -1, rand(R) * 7 - 3>;
  #for (K, 0, 2)
    cone { P + K * 0.6 * y, 0.6 - K * 0.13, P + (K * 0.6 + 1) * y, 0 pigment { rgb <0.1, 0.4 + 0.1 * K, 0.15> } }
  #end
#end
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
