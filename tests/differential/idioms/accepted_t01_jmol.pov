// Exported by a viewer of molecules
#version 3.5;
#declare Width = 160;
#declare Height = 120;
#declare minScreenDimension = 120;
#declare wireRadius = 1 / minScreenDimension * 50;
#declare showAtoms = true;
#declare showBonds = true;
background { color rgb <1,1,1> }
camera{ location < 80, 60, -250> right <-1.33,0,0> sky < 0, -1, 0> look_at < 80, 60, 0> angle 40 }
light_source { < -80, -160, -360> rgb <.8,.8,.8> }
#default { finish { ambient .4 diffuse .84 specular .22 roughness .02 phong .9 phong_size 120 } }
#macro a(X,Y,Z,RADIUS,R,G,B) sphere{<X,Y,Z>,RADIUS pigment{rgb<R,G,B>}} #end
#macro q(XX,YY,ZZ,XY,XZ,YZ,X,Y,Z,J,R,G,B) quadric{<XX,YY,ZZ>,<XY,XZ,YZ>,<X,Y,Z>,J pigment{rgb<R,G,B>}} #end
#macro b(X1,Y1,Z1,RADIUSTOP,X2,Y2,Z2,RADIUSBOT,R,G,B) cylinder{<X1,Y1,Z1>,<X2,Y2,Z2>,RADIUSTOP pigment{rgb<R,G,B>}} #end
#macro c(X1,Y1,Z1,RADIUS,R,G,B) sphere{<X1,Y1,Z1>,RADIUS pigment{rgb<R,G,B>} no_shadow} #end
#if (showAtoms) a(40,60,10,12,1,0,0) a(80,50,20,15,.5,.5,.5) a(120,70,0,12,.2,.2,1) #end
#if (showBonds)
b(40,60,10,4,80,50,20,4,.8,.8,.2)
b(80,50,20,4,120,70,0,4,.8,.8,.2)
#end
polygon { 4 <20,100,30>,<140,100,30>,<140,110,20>,<20,110,20> pigment{rgbt<.2,.7,.2,.4>} }
text { ttf "cyrvetic.ttf" "H2O" 1, 0 pigment{rgb 0} scale <12,-12,12> translate <60,20,0> }
