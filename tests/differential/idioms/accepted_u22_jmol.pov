//******************************************************
// Created by Jmol 14.0
//******************************************************
#declare RENDER = 1;
#declare jmol_width = 320; #declare jmol_height = 240;
#declare shadows = false; // shadows are optional
#declare Width = jmol_width;
#declare Height = jmol_height;
#declare wireRadius = 1 / 320 * 2.0;
#declare showAtoms = true; #declare showBonds = true; #declare noShadow = true;
camera{ orthographic
 location < 160, 120, 0> / Width
 right < 1, 0, 0> * 1  up <0, -1, 0>*Height/Width
 direction < 0, 0, 1>  sky < 0, -1, 0 > 
 look_at < 160/320, 120/320, 1 > }
background { color rgb <1,1,1> }
light_source { <-100, -100, -200> rgb <0.8,0.8,0.8> }
#default { finish {
  ambient 0.45
  diffuse 0.84
  specular 0.22
  roughness .00001
  metallic
  phong 0.9
  phong_size 120
}}
#macro check_shadow()
 #if (noShadow)
  no_shadow 
 #end
#end
#declare slabZ = 1e10; #declare depthZ = 1e11; #declare dzSlab = 10; #declare dzDepth = dzSlab; #declare dzStep = 0.001;
#macro clip()
 #if (slabZ < 0) clipped_by { box { <0,0,-slabZ>,<1,1,1> } } #end
#end
#macro a(X,Y,Z,RADIUS,R,G,B,T)
 sphere{<X,Y,Z>,RADIUS
  pigment{rgbt<R,G,B,T>}
  translate<0,0,0>
  clip() check_shadow()}
#end
#macro q(XX,YY,ZZ,XY,XZ,YZ,X,Y,Z,J,R,G,B,T)
 quadric{<XX,YY,ZZ>,<XY,XZ,YZ>,<X,Y,Z>,J
  pigment{rgbt<R,G,B,T>}
  clip() check_shadow()}
#end
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2
  pigment{rgbt<R,G,B,T> }
  clip() check_shadow()}
#end
#macro c(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2 open
  pigment{rgbt<R,G,B,T> }
  clip() check_shadow()}
#end
#macro p(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3,R,G,B,T)
 triangle{<X1,Y1,Z1>,<X2,Y2,Z2>,<X3,Y3,Z3>
  pigment{rgbt<R,G,B,T>}
  clip() check_shadow()}
#end
#macro isosurface_x(N) #end
union {
a(0.5,0.4,0.6,0.08,0.6,0.6,0.6,0)
a(0.7,0.3,0.6,0.06,1,0,0,0.2)
b(0.5,0.4,0.6,0.02,0.7,0.3,0.6,0.02,0.6,0.6,0.6,0)
c(0.2,0.2,0.6,0.02,0.3,0.3,0.6,0.04,0.2,0.6,0.6,0)
p(0.1,0.1,1,0.4,0.1,1,0.3,0.4,1,0,0,1,0.5)
}
