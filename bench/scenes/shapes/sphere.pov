// A pyramid of balls on the ground.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare N = 7;
#for (Layer, 0, N - 1)
  #for (I, 0, N - 1 - Layer)
    #for (K, 0, N - 1 - Layer)
      sphere {
        <I - (N - 1 - Layer) / 2, Layer * 0.7071, K - (N - 1 - Layer) / 2> * 0.75, 0.37
        pigment { rgb <0.4 + 0.08 * I, 0.3 + 0.1 * Layer, 0.4 + 0.08 * K> }
      }
    #end
  #end
#end
plane { y, -0.38 pigment { rgb <0.5, 0.6, 0.5> } }
