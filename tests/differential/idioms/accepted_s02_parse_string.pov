#version 3.6;
global_settings { assumed_gamma 1.8 }
#macro Parse(S) #fopen F "parse_tmp.inc" write #write (F, S) #fclose F #include "parse_tmp.inc" #end
#declare Names = array[3] { "sphere", "box", "cylinder" };
#declare Args = array[3] { "{ 0, .6", "{ -.5, .5", "{ -.5*y, .5*y, .5" };
#local k = 0;
#while (k < 3)
  Parse(concat(Names[k], Args[k], " pigment { rgb <", vstr(3, <k/2, .5, 1-k/2>, ",", 0, 3), "> } translate ", str(1.5*(k-1),0,2), "*x }"))
  #local k = k + 1;
#end
#declare Val = Parse("3*(2+1)");
#debug concat("Val=", str(Val,0,3), " ", strupr(Names[1]), " ", substr(Names[2],2,3), "\n")
camera { location <0,1,-4> look_at 0 }
light_source { <3,4,-5> rgb 1 }
