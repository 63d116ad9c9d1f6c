// A smooth mesh of 20,000 triangles and copies of it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare N = 100;
#macro P(U, V) #local R = 1 + 0.2 * sin(5 * U) * sin(4 * V); <R * cos(U) * sin(V), R * cos(V), R * sin(U) * sin(V)> #end
#declare Ball = mesh2 {
  vertex_vectors { (N + 1) * (N + 1), #for (I, 0, N) #for (K, 0, N) P(2 * pi * I / N, pi * K / N), #end #end }
  normal_vectors { (N + 1) * (N + 1), #for (I, 0, N) #for (K, 0, N) P(2 * pi * I / N, pi * K / N), #end #end }
  face_indices { 2 * N * N, #for (I, 0, N - 1) #for (K, 0, N - 1) #local A = I * (N + 1) + K; <A, A + 1, A + N + 1>, <A + 1, A + N + 2, A + N + 1>, #end #end }
}
#for (I, -1, 1)
  object { Ball rotate 40 * I * y translate <2.4 * I, 0.2, 0> pigment { rgb <0.6 + 0.2 * I, 0.6, 0.6 - 0.2 * I> } }
  object { Ball scale 0.6 translate <2 * I, 0.2, -2.6> pigment { rgb <0.6, 0.6 + 0.2 * I, 0.6> } }
#end
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
