#declare T = texture { pigment { rgb 1 } }
mesh { triangle { <0,0,0>, <1,1,0>, <0,1,0> texture { T } } triangle { <0,0,0>, <1,1,0>, <0,1,0> uv_vectors <0,0>,<1,0>,<0,1> } inside_vector y }
