#version 3.7;
global_settings { assumed_gamma 1.0 charset utf8 }
#declare S = "Zeile";
#declare i = 1;
#while (i <= 3)
  #declare S = concat(S, "-", str(i,-3,0), chr(64+i));
  #declare i = i + 1;
#end
#debug concat(S, "|", strlwr(S), "|", str(strlen(S),0,0), "|", str(asc(S),0,0), "|", str(strcmp(S,"Zeile-"),0,0), "|", substr(S,7,4), "|", str(val("2.5e1"),4,1), "\n")
#if (("abc" < "abd") & (strlen("") = 0)) #debug "less\n" #end
#macro Rep(s, n) #local r = ""; #for (k, 1, n) #local r = concat(r, s); #end r #end
#declare R = Rep("ab", 3)
#debug concat(R, "\n")
text { ttf "timrom.ttf", Rep("A", 4), .3, <.05,0,0> pigment { rgb <.9,.7,.2> } finish { specular .4 } translate -1.2*x }
camera { location <0,.5,-4> look_at <0,.3,0> } light_source { <2,5,-6> rgb 1 }
