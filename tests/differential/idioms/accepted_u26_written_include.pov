// MakeTree / POV-Tree file output and reading back
#version 3.5;
#include "colors.inc"
#declare dofile = true;
#declare ffname = "u_tree_tmp.inc"
#declare rd = seed(5);
#if (dofile)
 #fopen filehandle ffname write
 #write (filehandle, "#declare TREE_X = union {\n")
 #macro writeSeg(a, b, r) #write (filehandle, "cone{", a, ", ", r, ", ", b, ", ", r*.6, "}\n") #end
 #macro grow(a, dir, n, r)
  #local b = a + dir;
  writeSeg(a, b, r)
  #if (n > 0)
   grow(b, vaxis_rotate(dir, x, 35)*.7, n-1, r*.6)
   grow(b, vaxis_rotate(dir, z, -30)*.75, n-1, r*.6)
  #end
 #end
 grow(<0,0,0>, <0,1,0>, 4, .15)
 #write (filehandle, "}\n#declare LeafN = ", 12, ";\n")
 #fclose filehandle
#end
#include ffname
#debug concat("leaf ", str(LeafN,0,0), "\n")
object { TREE_X pigment { Brown } }
#fopen D "u_tree_tmp.csv" write
#write (D, 1, ",", 2.5, ",\n", <1,2,3>, ",", "\"name\"", ",\n")
#fclose D
#fopen D "u_tree_tmp.csv" read
#while (defined(D)) #read (D, A_, B_, C_, N_) #debug concat(str(A_,0,1)," ",str(B_,0,1)," ",vstr(3,C_,",",0,1)," ",N_,"\n") #end
light_source { <5,9,-7> White }
camera { location <0,2,-6> look_at <0,1.7,0> }
