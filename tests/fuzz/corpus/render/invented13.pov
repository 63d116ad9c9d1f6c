#version 1.0;
global_settings {  }
#default { finish { specular 0 specular 0 } }
#declare Texture1 = texture { pigment { square rgb x+y*0.5 rgb <0.25,0.8,0.5> colour rgb 0.25 color <0.81,0.5,1> warp { repeat 2*z offset <0.5,0,0> } turbulence 1 } finish { conserve_energy specular 0.25 } scale 0.5 }
#local Object2 = cylinder { <0,-1 -2>, y*2, 0.75 open  }
camera { perspective aperture 0.2 blur_samples 4 focal_point 0 location <-4,1,-4> right x*4/3 aperture 0.2 blur_samples 4 focal_point 0 }
background { rgb <0.16,0.25,0> }
cylinder { <-0.5,0,-0.5>, y*2, 1.0  translate <1,0.399,-0.5> clipped_by { plane { x, 0 } } }
mesh2 { vertex_vectors { 4, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0.5> } normal_vectors { 4, -z, <1,0,-1>, <0,1,-1>, -z } uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0,1> } face_indices { 2, <0,1,2>, <0,2,3> } texture { square texture { pigment { triangular   } },texture { pigment { checker   } },texture { pigment { pigment_pattern { rgb 0.5 } color_map { [0 rgb <0.1,0.8,0.8>] [0.4, rgb <0.5,1,0.8>] [1 rgb <1,1,1>] } translate x-y omega 0.42 omega 0.5 } },texture { pigment { color red 0.5  } translate <-2, 0 2> }  } }
mesh { triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> } smooth_triangle { <-1,0,-1>, y, <1,0,-1>, x, <0,0,1>, -z } triangle { <0,-1,0>, <1,0,0>, <0,1,1> } hierarchy off translate <1,-1 0> clipped_by { bounded_by } }
mesh2 { vertex_vectors { 4, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0.5> } face_indices { 2, <0,1,2>, <0,2,3> } inside_vector y  }
plane { y, -0.5 no_image }
