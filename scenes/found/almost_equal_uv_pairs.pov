// Neighbours in a mesh whose UV coordinates differ in their last bits: POV-Ray keeps one of them, the first, but for
// those beside u = 1/2, where its table is divided (spec 04, 1.1). A pigment of grains shows the bits.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = 12;
mesh {
  #for (I, 0, N - 1)
    #declare U = (I + 0.5) / N;
    triangle { <I, 0, 0>, <I + 1, 0, 0>, <I, 1, 0> uv_vectors <U, 0.3>, <U, 0.3>, <U, 0.3> }
    triangle { <I + 1, 1, 0>, <I, 1, 0>, <I + 1, 0, 0> uv_vectors <U + 4e-11, 0.3>, <U + 4e-11, 0.3>, <U + 4e-11, 0.3> }
    #declare U = I / N + 0.5 * (I = 0);
    triangle { <I, 1, 0>, <I + 1, 1, 0>, <I, 2, 0> uv_vectors <U, 0.6>, <U, 0.6>, <U, 0.6> }
    triangle { <I + 1, 2, 0>, <I, 2, 0>, <I + 1, 1, 0> uv_vectors <U - 4e-11, 0.6>, <U - 4e-11, 0.6>, <U - 4e-11, 0.6> }
  #end
  uv_mapping
  pigment { function { mod(x * pow(2, 30) + 0.25, 1) } color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 1, 1>] } }
  finish { ambient 1 diffuse 0 }
}
camera { orthographic location <N / 2, 1, -4> right N * x up 3 * y direction z }
