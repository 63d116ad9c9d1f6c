#version 3.5;
#include "functions.inc"
#include "colors.inc"
// IsoCSG-like macros
#macro IC_Sphere(Pos, R) #local f = function { f_sphere(x-Pos.x, y-Pos.y, z-Pos.z, R) } f #end
#declare IC_Sphere_F = function(x,y,z,px,py,pz,r) { f_sphere(x-px,y-py,z-pz,r) }
#macro IC_Blob2(F1, F2, S) #local Fn = function { 1 - pow(S, F1(x,y,z)) - pow(S, F2(x,y,z)) } function { Fn(x,y,z) } #end
#declare A = function { IC_Sphere_F(x,y,z,-0.5,0,0,0.6) }
#declare B = function { f_rounded_box(x-0.5,y,z, 0.1, 0.4,0.4,0.4) }
isosurface {
  function { max(min(A(x,y,z), B(x,y,z)), -(f_th(x,y,z)*0 + abs(y)-0.02)) - f_noise3d(x*10,y*10,z*10)*0.05 }
  contained_by { box { <-2,-2,-2>, <2,2,2> } }
  threshold 0.0
  accuracy 0.002
  max_gradient 3
  evaluate 2, 1.2, 0.99
  all_intersections
  pigment { rgb <0.6,0.7,0.9> } finish { specular 0.4 }
}
isosurface { IC_Blob2(A, B, 0.01)
  contained_by { sphere { 0, 2 } } max_gradient 12 translate y*1.5 pigment { Orange } }
isosurface { function { y + 1 + f_snoise3d(x*2,0,z*2)*0.2 } contained_by { box { <-3,-2,-3>,<3,0,3> } } max_gradient 2 open pigment { color Green*0.5 } }
light_source { <4,6,-6>, 1 }
camera { location <0,1.5,-5> look_at <0,0.4,0> }
