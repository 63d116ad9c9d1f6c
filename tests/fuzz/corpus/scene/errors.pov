#version 3.7;
sphere { 0, bad1 }
#declare T = texture { pigment { colr rgb 1 } }
box { 0, 1 texture { T } }
#declare F = function(n) { select(n-1, 1, 1, n*F(n-1)) }
#macro M(a) sphere { 0, a oops } #end
M(1) M(2)
#while (x) #end
#if (1) union { sphere { 0,1 } #else box { #end }
cylinder { 0, y, F(3) texture { T } }
