// Rays through the very edge of boxes: of the two faces the farther one is seen, in CSG the nearer one, and some rays are
// refused by the boxes of the hierarchy, in single precision.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <6, 3, -6> look_at 0 right 8*x up 6*y }
light_source { <4, 8, -6> rgb 1 }
background { rgb <0.1, 0.2, 0.7> }
#declare I = 0;
#while (I < 5)
  box { 0, <0.5, 0.5 + I/5, 0.5> translate <I*0.5 - 2, 0, 0> pigment { rgb <1, I/4, 0> } finish { ambient 0.3 } }
  #declare I = I + 1;
#end
box { <-4, -1.5, -1.5>, <1, -1, 5> pigment { rgb <0.3, 0.9, 0.5> } }
merge { box { <0.5, 1.5, 0>, <0, 1, -1> } box { <-0.5, 0.5, -1>, 1 } pigment { rgb <0.4, 0.3, 1> } }
difference { difference { box { <-1, -1, -1>, 1 } sphere { <1, 1, -1>, 0.7 } } box { <-0.5, -2, -0.5>, <0.5, 2, 0.5> } translate <-2, 1.5, 2> pigment { rgb <1, 0.4, 0.9> } }
