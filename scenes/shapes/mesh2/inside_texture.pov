// the inner side of mesh2, seen through its glassy front
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare S = mesh2 { vertex_vectors { 5, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <0, 0, -1> } normal_vectors { 5, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <0, 0, -1> } uv_vectors { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0.5, 0.5> } face_indices { 6, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4>, <0, 1, 2>, <0, 2, 3> } inside_vector <0.1, 0.2, 0.9> }
object { S texture { pigment { rgbt <0.6, 0.8, 1, 0.7> } finish { ambient 0.1 diffuse 0.6 } } interior_texture { pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.1 diffuse 0.8 } } }
