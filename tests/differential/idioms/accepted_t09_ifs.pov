#version 3.0
#ifdef (High_Quality) #declare N = 40 #else #declare N = 12 #end
#ifndef (Radius) #declare Radius = 1.2 #end
#declare K = 0
union {
#while (K < N)
  #if (mod(K,3) = 0)
    sphere { <Radius,0,0>, .2 rotate z*K*360/N }
  #else #if (mod(K,3) = 1)
    box { <-.15,-.15,-.15>, <.15,.15,.15> translate Radius*x rotate z*K*360/N }
  #else
    cone { <Radius,0,0>, .2, <Radius+.3,0,0>, 0 rotate z*K*360/N }
  #end #end
  #declare K = K + 1
#end
  pigment { color red 1 green .6 }
}
camera { location <0,0,-4> look_at <0,0,0> }
light_source { <2,4,-6> color red 1 green 1 blue 1 }
#switch (clock) #case (0) #range (0.5,1) background { color rgb <0,0,.3> } #break #else background { color rgb <.3,0,0> } #end
