#version 3.7;
#declare A = array[2][2] { { 1, 2 }, { 3, 4 } }
#macro M(p, q) (p + q) #end
sphere { 0, M(1, A[1e300][0]) pigment { rgb A[0][-3e9] } }
