#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = array[2][2]{{1,2},{3,4}}
#macro M(p, q) #local r = p+q; #if (r > 3) r #else (r*2) #end #end
#declare S = spline { natural_spline 0,<0,0,0> 1,<1,2,3> 2,<0,1,0> }
#declare F = function(u,v) { u*2-v/3+select(u,1,2,3)+sum(i,1,3,i) }
#for (i, 0, 2, .5) #debug concat(str(M(i,1),0,3), vstr(3,S(i)*F(i,2),",",0,2), "\n") #end
#switch (2) #case (1) #break #range (2,3) #declare B = rgbft <.1,.2,.3,.4,.5>; #break #else #error "no" #end
#declare i = 0; #while (i < 3) #declare i = i+1; #if (i = 2) #break #end #end
sphere { 0, M(1,A[1][0]) pigment { color B } }
