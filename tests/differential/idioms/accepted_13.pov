// Jmol
#version 3.5;
#declare Width = 500; #declare Height = 500; #declare Shadows = false;
#declare noShadows = (Shadows = false);
camera{ orthographic location < 250, 250, 0> direction < 0, 0, 1>*1 sky < 0, -1, 0> right < 500, 0, 0> up < 0, 500, 0> look_at < 250, 250, 1000> }
background { color rgb <0,0,0> }
#macro r(X,Y,Z,RADIUS,R,G,B,T) sphere{<X,Y,Z>,RADIUS pigment{rgbt<R,G,B,T>} finish{ambient .45 diffuse .84 specular .22 roughness .00001 metallic phong 0.9 phong_size 120} #if (noShadows) no_shadow #end } #end
#macro p(X,Y,Z,RADIUS,R,G,B,T) #declare dummy = 1; #end
#macro translucentFinish(T) #local shineFactor = T; #if (T <= 0.25) #declare shineFactor = (1.0-4*T); #end #if (T > 0.25) #declare shineFactor = 0; #end finish { ambient 0.45 diffuse 0.84 specular 0.22*shineFactor roughness 0.00001 metallic phong 0.9*shineFactor phong_size 120*shineFactor }#end
r(1,2,3,0.5,1,0,0,0.0)
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T) cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2 open pigment{rgbt<R,G,B,T>} translucentFinish(T)} #end
b(0,0,0,.2,1,1,1,.3,1,1,0,0.5)
