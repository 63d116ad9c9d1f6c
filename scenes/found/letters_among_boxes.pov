// Each letter of the text has a place of its own in the hierarchy, which decides between faces in the same place.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { location <-1, 3, -5> sky <0.2, 1, 0> look_at 0 }
#declare I = 0;
#while (I < 9)
  box { 0, <0.5, 0.5 + I/9, 0.5> translate (I*0.5 - 2)*x pigment { rgb <0.5, 0.5, 0.25> } }
  #declare I = I + 1;
#end
text { ttf "crystal.ttf" "xa =1" 0.5, 0.1*x pigment { rgb 0 } }
#declare I = 0;
#while (I < 12)
  box { 0, <0.5, 0.5 + I/12, 0.5> translate (I*0.5 - 2)*x pigment { rgb <0.5, 0.25, 0.8> } }
  #declare I = I + 1;
#end
