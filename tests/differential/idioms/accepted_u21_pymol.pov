camera {direction<0.0,0.0,  -2.836>
 location <0.0 , 0.0 , 0.0>
 right 1.333*x up y 
 }
#default { texture { finish{phong 0.7 ambient 0.140 diffuse 0.45 phong_size 60}}}
light_source{<4000.0001,4000.0001,9750.0000> rgb<1,1,1>}
plane{z , -120.0000 
 pigment{color rgb<0.0000,0.0000,0.2000>}
 finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
mesh2 { vertex_vectors {3, <1,2,-50>,<3,2,-50>,<2,4,-52> } normal_vectors { 3, <0,0,1>,<0,0.1,1>,<0.1,0,1> } texture_list { 3, texture{pigment{color rgb<1,0,0>}},texture{pigment{color rgb<0,1,0>}},texture{pigment{color rgb<0,0,1>}} } face_indices { 1, <0,1,2>,0,1,2 } }
sphere{<-2.0,1.0,-50.0>, 1.7000000
pigment{color rgb<0.3,1.0,0.3>}}
sphere{<-2.0,-1.5,-50.0>, 1.2
pigment{color rgb<1.0,0.3,0.3> transmit 0.4}}
cylinder{<-2,1,-50>,
<2.5,-1.5,-48>,
 0.25
pigment{color rgb<0.8,0.8,0.2>}}
smooth_triangle{<0,0,-48>,
<0,0,1>,
<1,0,-48>,
<0.1,0,1>,
<0,1,-48>,
<0,0.1,1>
pigment{color rgb<0.1,0.8,0.9> filter 0.5}
}
