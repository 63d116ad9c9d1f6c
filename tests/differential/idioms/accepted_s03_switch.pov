#declare i = -3;
#while (i <= 3)
  #declare j = -2;
  #while (j <= 2)
    #switch (i*j)
      #case (0) #declare C = rgb <1,1,1>; #break
      #case (6)
      #case (-6) #declare C = rgb <1,0,0>; #break
      #range (1,5) #declare C = rgb <0,1,0>; #break
      #range (-5,-1) #declare C = rgb <0,0,1>;
        #if (j > 0) #declare C = C + <.5,.5,0>; #end
      #break
      #else #declare C = rgb <1,1,0>;
    #end
    box { <i,j,0>, <i+.9,j+.9,.3> pigment { C } }
    #declare j = j + 1;
  #end
  #declare i = i + 1;
#end
camera { location <.5,.5,-8> look_at <.5,.5,0> }
light_source { <2,3,-9> rgb 1 }
