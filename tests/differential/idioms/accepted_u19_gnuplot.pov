// scientific plot, mesh exported by a script
#version 3.7;
global_settings{assumed_gamma 1.0}
#declare NX=20; #declare NY=20;
#declare Z=array[NX][NY];
#for(I,0,NX-1) #for(J,0,NY-1) #declare Z[I][J]=sin(I*0.5)*cos(J*0.4)*exp(-pow((I-10)/10,2)); #end #end
#macro ColMap(V) #local t_=min(1,max(0,(V+1)/2)); rgb <t_,1-abs(2*t_-1),1-t_> #end
mesh2{
 vertex_vectors{ NX*NY #for(I,0,NX-1) #for(J,0,NY-1) ,<I/NX,Z[I][J]*0.3,J/NY> #end #end }
 texture_list{ NX*NY #for(I,0,NX-1) #for(J,0,NY-1) ,texture{pigment{ColMap(Z[I][J])}} #end #end }
 face_indices{ 2*(NX-1)*(NY-1)
 #for(I,0,NX-2) #for(J,0,NY-2)
 #local A=I*NY+J; #local B=A+1; #local C=A+NY; #local D=C+1;
 ,<A,B,C>,A,B,C ,<B,D,C>,B,D,C
 #end #end }
 translate <-.5,0,-.5> scale 3
}
#macro Axis(P,Len,Lbl) cylinder{0,P*Len,0.01 pigment{rgb 0}} cone{P*Len,0.03,P*(Len+.1),0 pigment{rgb 0}} text{ttf "timrom.ttf",Lbl,0.01,0 scale .2 translate P*(Len+.15) pigment{rgb 0}} #end
union{Axis(x,1.6,"x") Axis(y,1,"y") Axis(z,1.6,"z") translate <-1.5,0,-1.5>}
background{rgb 1}
camera{orthographic location <3,3,-4>*2 look_at 0 right x*4*image_width/image_height up y*4}
light_source{<5,10,-8>,1 parallel point_at 0}
