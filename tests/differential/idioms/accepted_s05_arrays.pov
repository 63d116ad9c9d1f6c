#version 3.5;
#declare Inner1 = array[2] { 1, 2 }
#declare Inner2 = array[2] { 3, 4 }
#declare Grid = array[2] { Inner1, Inner2 }
#declare Texs = array[2] { texture { pigment { rgb x } }, texture { pigment { rgb y } finish { phong 1 } } }
#declare Objs = array[2]
#declare Objs[0] = sphere { 0, .5 texture { Texs[0] } }
#declare Objs[1] = box { -.4, .4 texture { Texs[1] } rotate 30 }
#declare Mat = array[2][2] { { <1,2,3>, <4,5,6> } { <7,8,9>, <10,11,12>, } }
#macro Sum(A) #local s = 0; #local i = 0; #while (i < dimension_size(A,1)) #local s = s + A[i]; #local i = i+1; #end s #end
#debug concat(str(Grid[1][0],0,0), " ", str(Sum(Inner2),0,0), " ", vstr(3, Mat[1][1], ",", 0, 0), " ", str(dimensions(Mat),0,0), str(dimension_size(Mat,2),0,0), "\n")
#macro Fill(A, n) #local i = 0; #while (i < n) #declare A[i] = i*i; #local i = i+1; #end #end
#declare Sq = array[5]
Fill(Sq, 5)
#declare Copy = Sq;
#declare Copy[2] = 99;
#debug concat(str(Sq[2],0,0), " ", str(Copy[2],0,0), "\n")
#ifdef (Sq[3]) object { Objs[0] translate -x } #end
#ifndef (Objs[0]) sphere { 0,9 } #else object { Objs[1] translate x } #end
camera { location -4*z look_at 0 }
light_source { <3,4,-5>, 1 }
