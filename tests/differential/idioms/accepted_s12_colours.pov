#version 3.7; global_settings { assumed_gamma 1.0 }
#declare C1 = colour red 0.4 green 0.7;
#declare C2 = color rgb <.2,.3,.9> filter .3 ;
#declare C3 = rgbft <1,.8,.2,.1,.2>;
#declare C4 = srgb <0.8,0.4,0.2>;
#declare C5 = C1*.5 + C4;
#declare C6 = C3; #declare T = C3.transmit; #declare Gr = C4.gray;
#debug concat(vstr(5,C1,",",0,5)," ",vstr(5,C2,",",0,5)," ",vstr(5,C5,",",0,5)," ",str(T,0,4)," ",str(Gr,0,6),"\n")
#declare i = 0;
#while (i < 6)
  sphere { <i-2.5,0,0>,.45 pigment { #switch (i) #case (0) C1 #break #case (1) color C2 #break #case (2) colour C3 #break #case (3) C4 #break #case (4) C5 #break #else color C6 transmit .5 #end } }
  #declare i = i+1;
#end
background { colour red .1 green .1 blue .2 }
light_source { <1,3,-6> color red 1 green 1 blue 1 }
camera { location -5*z look_at 0 }
