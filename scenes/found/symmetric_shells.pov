// Two shells of the same spheres, cylinders and boxes in one place. Where POV-Ray's hierarchy divides entries as regular
// as these hangs on the last bits of surface areas, which are computed in double precision (spec 08 A).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 direction z up 1.5*y right 2*x }
#default { finish { ambient 1 diffuse 0 } }
#macro Shell(Radius)
  union {
    #local K = 0;
    #while (K < 8)
      #local P = <mod(K, 2)*1.6 - 0.8, mod(int(K/2), 2)*0.6 + 0.2, int(K/4)*1.6 - 0.8>;
      sphere { P, Radius }
      #if (P.x < 0) cylinder { P, P + 1.6*x, Radius } #end
      #if (P.y < 0.5) cylinder { P, P + 0.6*y, Radius } #end
      #if (P.z < 0) cylinder { P, P + 1.6*z, Radius } #end
      #local K = K + 1;
    #end
    box { <-1, 0.2, -0.8>, <1, 0.8, 0.8> }
    box { <-0.8, 0, -0.8>, <0.8, 1, 0.8> }
    box { <-0.8, 0.2, -1>, <0.8, 0.8, 1> }
  }
#end
union { Shell(0.2) pigment { rgb <0.2, 0.5, 0.7> filter 0.5 } }
union { Shell(0.2) pigment { rgb <0.5, 0.1, 0.1> } }
