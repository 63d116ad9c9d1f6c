// PyMOL
camera {direction<0.0,0.0,  -2.747>
 location <0.0 , 0.0 , 0.0>
 right 1.333*x up y
 }
#default { texture { pigment { color rgb <1,1,1> } finish { ambient 0.2 diffuse 0.4 phong 0.4 phong_size 12.0} } }
light_source{<4000.0001,4000.0001,9973.6>  rgb<1.0,1.0,1.0>}
plane{z , -200.0 
 pigment{color rgb<0.0,0.0,0.0>}
 finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
mesh2 { vertex_vectors { 3, <1,2,-3>, <2,2,-3>, <1,3,-3> } normal_vectors { 3,
<0.1,0.2,0.9>,
<0.1,0.2,0.9>,<0.1,0.2,0.9> }
texture_list { 3,
texture { pigment{color rgb<1,0,0>} },
texture { pigment{color rgb<0,1,0>} }, 
texture { pigment{color rgb<0,0,1>} } }
face_indices { 1, <0,1,2>, 0, 1, 2 } }
cylinder{<0,0,-4>,<1,1,-4>, 0.25 pigment{color rgb<1,1,0>}}
