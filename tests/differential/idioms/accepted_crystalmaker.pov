/* Crystal drawing: bonds, polyhedra with transparent faces, unit cell edges.
   /* nested comment */ still inside */
#include "colors.inc"
#declare atomFinish = finish { phong 0.7 phong_size 25 ambient 0.35 diffuse 0.6 reflection 0.03 }
#declare Cell = array[3] { <4.1,0,0>, <0.6,3.9,0>, <0,0,4.4> }
#declare Types = array[3][2]
{
  { 0.35, 0.9 },
  { 0.25, 0.4 },
  { 0.5, 0.1 }
}
#declare Frac = array[4] { <0,0,0>, <.5,.5,0>, <.5,0,.5>, <0,.5,.5> }
#macro Cart(F) (F.x*Cell[0]+F.y*Cell[1]+F.z*Cell[2]) #end
#for (i,0,1)
  #for (j,0,1)
    #for (k,0,1)
      #local n = 0;
      #while (n < dimension_size(Frac,1))
        #local T = mod(n, dimension_size(Types,1));
        sphere { Cart((Frac[n]+<i,j,k>)), Types[T][0]
          texture { pigment { rgb <Types[T][1], 1-Types[T][1], .5> } finish { atomFinish } }
        }
        #local n = n + 1;
      #end
    #end
  #end
#end
#macro Poly(A,B,C,D)
  mesh {
    triangle { A, B, C } triangle { A, C, D } triangle { A, B, D } triangle { B, C, D }
    pigment { color rgbt <.4,.6,1,.6> }
    finish { ambient .3 }
  }
#end
Poly(Cart(<0,0,0>),Cart(<.5,.5,0>),Cart(<.5,0,.5>),Cart(<0,.5,.5>))
#macro Edge(a,b) #local A = Cart(a); #local B = Cart(b); cylinder { A, B, 0.04 open no_shadow pigment { Black } } #end
Edge(0*x,2*x) Edge(0*x,2*y) Edge(0*x,2*z) Edge(2*x,2*x+2*y) Edge(2*y,2*x+2*y)
union { Edge(2*z,2*z+2*x) Edge(2*z,2*z+2*y) Edge(2*(x+y),2*(x+y+z)) }
text { ttf "timrom.ttf" "(001)" 0.1, 0.05*x pigment { Red } translate <0,-1,-1> }
camera { location <8,9,-14> look_at <4,3.5,4> angle 50 }
light_source { <20,30,-25> White }
background { White }
