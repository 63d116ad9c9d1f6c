#version 3.5;
// LEGO building-block macros in the manner of hobby libraries
#include "colors.inc"
#local Old_V = version;
#ifndef (LEGO_Inc_Temp)
#declare LEGO_Inc_Temp = 1;
#declare LW = 0.8; #declare LH = 0.96; #declare PegR = 0.24; #declare PegH = 0.18;
#macro Brick(NX, NZ, NH, Tex)
 #local K = 0;
 union {
  difference {
   box { <0,0,0>, <NX*LW, NH*LH/3, NZ*LW> }
   box { <.15,-.1,.15>, <NX*LW-.15, NH*LH/3-.15, NZ*LW-.15> }
  }
  #local I = 0; #while (I < NX) #local J = 0; #while (J < NZ)
   cylinder { 0, PegH*y, PegR translate <(I+.5)*LW, NH*LH/3, (J+.5)*LW> }
   #local K = K + 1;
   #local J = J+1; #end #local I = I+1; #end
  texture { Tex }
 }
#end
#end
#declare T_Red = texture { pigment { Red } finish { phong .8 } }
#declare T_Yellow = texture { pigment { Yellow } finish { phong .8 } }
#declare Wall = union {
 #local L = 0;
 #while (L < 4)
  #local S = mod(L,2)*LW*2;
  object { Brick(4,2,3, #if (mod(L,2)) T_Red #else T_Yellow #end) translate <S, L*LH, 0> }
  object { Brick(2,2,3, T_Red) translate <S + 4*LW, L*LH, 0> }
  #local L = L + 1;
 #end
}
object { Wall rotate y*20 translate -x*2 }
plane { y,0 pigment { rgb .9 } }
light_source { <-5,10,-10> White }
camera { location <0,5,-12> look_at <0,2,0> }
#version Old_V;
