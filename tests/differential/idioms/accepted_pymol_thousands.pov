// A molecule viewer's export: hundreds of spheres and cylinders on short lines, clipped by planes, depth cue by fog
#version 3.5;
#declare TR = 0.25;
camera {orthographic direction<0.0,0.0,  -1>
 location <0.0 , 0.0 , 60.0> right 40*x up 30*y
 }
#default { texture { pigment { color rgb <1,1,1> } finish { ambient 0.160 diffuse 0.450 phong 0.500 phong_size 13.75} } }
light_source{<4000.0001,4000.0001,9940.4> rgb<1.0,1.0,1.0>}
light_source{<-400,200,900> rgb .3 shadowless}
#macro S(P,R,C) sphere{P, R texture{pigment{color C}}} #end
#macro L(A,B,R,C1,C2)
  #if (vlength(A-B) > 1e-6)
  cylinder{A,(A+B)/2,R texture{pigment{color C1}}}
  cylinder{(A+B)/2,B,R texture{pigment{color C2}}}
  #end
#end
#declare N = 0; #declare R1 = seed(12);
#while (N < 400)
  #declare P = <18*sin(N*.31)*rand(R1), 12*cos(N*.17), 14*sin(N*.05)-6>;
  #switch (mod(N,5))
  #case (0) S(P, .9, rgb <.2,.2,1>) #break
  #range (1,2) S(P, .8, rgb<.6+.4*rand(R1),.3,.3>) #break
  #case (3)
    L(P, P+<1.5,1,0>, .2, rgb<1,1,0>, rgbt<0,1,1,TR>)
  #else
    sphere{P,.6 pigment{color rgb<.33,.9,.3>}}
  #end
  #declare N = N + 1;
#end
fog { distance 60 color rgb<0,0,0> fog_type 1 }
