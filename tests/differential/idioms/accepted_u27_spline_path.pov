#version 3.6;
// particle system / animation with clock and splines
#include "rand.inc"
#include "colors.inc"
global_settings { assumed_gamma 2.2 }
#declare Path = spline { natural_spline -0.25,<-3,1,0> 0,<-2,0.5,1> 0.5,<0,1.5,-1> 1,<2,.5,1> 1.25,<3,1,0> }
#declare S = seed(frame_number+11);
#declare P = Path(clock);
#declare Next = Path(clock+0.02);
#declare Dir = vnormalize(Next-P);
#declare Ship = union { cone { -z*.5, .3, z*.7, 0 } box { <-.8,-.05,-.4>, <.8,.05,-.1> } pigment { rgb <.7,.7,.8> } finish { specular .5 } }
#macro Look_Along(D) #local R = vnormalize(vcross(y, D)); #local U = vcross(D, R); matrix < R.x,R.y,R.z, U.x,U.y,U.z, D.x,D.y,D.z, 0,0,0 > #end
object { Ship Look_Along(Dir) translate P }
#local I = 0;
#while (I < 30)
  #local Q = Path(I/30) + VRand_In_Sphere(S)*.2;
  sphere { Q, .04+.03*rand(S) pigment { rgbt <1, rand(S), .1, .3> } finish { ambient .8 } no_shadow }
  #local I = I + 1;
#end
#switch (clock)
  #range (0, .5) background { rgb <0,0,.1> } #break
  #range (.5, 1) background { rgb <.1,0,0> } #break
#end
#ifdef (My_Option) #error "no" #else #declare My_Option = on; #end
#ifndef (View) #declare View = 1; #end
camera { #if (View = 1) location <0,2,-6> look_at <0,.8,0> #else location P look_at Next #end angle 50 }
light_source { <-5,8,-7>, color rgb 1.2 }
