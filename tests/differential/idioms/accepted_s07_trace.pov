#version 3.5;
#declare Hill = union { sphere { 0, 1.2 scale <1.6,.6,1.6> } torus { 1.5, .4 } box { <-.3,0,-.3>,<.3,1,.3> rotate 20*y } }
#declare S = seed(77);
object { Hill pigment { rgb <.4,.7,.3> } }
#declare Hits = 0;
#while (Hits < 60)
  #declare N = <0,0,0>;
  #declare At = trace(Hill, <4*rand(S)-2, 5, 4*rand(S)-2>, -y, N);
  #if (vlength(N) != 0)
    #if (N.y > .3) cone { At, .06, At + .35*N, 0 pigment { rgb <.9,.3,.1> } } #else sphere { At, .05 pigment { rgb z } } #end
  #end
  #declare Hits = Hits + 1;
#end
#debug concat(vstr(3, min_extent(Hill), ",", 0, 5), " ", vstr(3, max_extent(Hill), ",", 0, 5), " ", str(inside(Hill, <0,.5,0>),0,0), "\n")
camera { location <3,4,-5> look_at 0 angle 45 }
light_source { <5,8,-6> 1 }
