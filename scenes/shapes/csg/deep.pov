// eight levels of alternating union and difference
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare A = sphere { 0, 1.3 }
#for (I, 1, 8) #declare B = #if (mod(I, 2)) difference { object { A } sphere { <cos(I * 2.4), sin(I * 2.4), -0.6> * (1.2 - 0.05 * I), 0.55 } } #else union { object { A } box { -0.25, 0.25 rotate 30 * I * z translate <cos(I * 2.4), sin(I * 2.4), -0.5> * 0.9 } } #end #declare A = B #end
object { A texture { Coat } rotate 15 * y }
