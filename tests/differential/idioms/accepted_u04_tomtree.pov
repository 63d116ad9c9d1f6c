#version 3.6;
#include "colors.inc"
#include "rand.inc"
#include "math.inc"
#include "transforms.inc"
global_settings { assumed_gamma 1.0 }
#declare rsd = seed(4711);
#declare levels = 4;
#macro RandRange(A,B) (A+rand(rsd)*(B-A)) #end
#macro Branch(P, D, L, R, Lev)
  #local N = 3;
  #local Q = P + D*L;
  cone { P, R, Q, R*0.7 }
  sphere { Q, R*0.7 }
  #if (Lev > 0)
    #local i = 0;
    #while (i < N)
      #local Perp = VPerp_To_Vector(D);
      #local D2 = vnormalize(vaxis_rotate(D*1.2 + Perp*RandRange(0.5,0.9), D, 360/N*i + RandRange(-20,20)));
      Branch(Q, D2, L*RandRange(0.6,0.8), R*0.65, Lev-1)
      #local i = i + 1;
    #end
  #else
    #declare LeafCount = LeafCount + 1;
    object { Leaf Reorient_Trans(y, D) translate Q }
  #end
#end
#declare LeafCount = 0;
#declare Leaf = mesh { triangle { <0,0,0>, <0.1,0.2,0>, <-0.1,0.2,0> } triangle { <0,0.4,0>, <0.1,0.2,0>, <-0.1,0.2,0> } pigment { rgb <0.2,0.6,0.1> } };
#declare TREE = union { Branch(<0,0,0>, y, 1.4, 0.14, levels) texture { pigment { wood color_map { [0 rgb <0.4,0.3,0.15>] [1 rgb <0.3,0.2,0.1>] } scale 0.1 } } };
object { TREE }
#debug concat("Leaves: ", str(LeafCount,0,0), "\n")
#debug concat("Extent: ", vstr(3, max_extent(TREE), ", ", 0, 4), "\n")
plane { y, 0 pigment { checker rgb 0.7, rgb 0.5 } }
light_source { <5,8,-6> White area_light x,y,3,3 adaptive 1 }
camera { location <0,2.5,-7> look_at <0,2,0> }
