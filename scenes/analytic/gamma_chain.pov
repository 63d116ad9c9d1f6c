// The chain of gammas: values of a scene that assumes a gamma of 2.2 become linear in the file as their power of 2.2 (in front); colours that are given as
// sRGB by its curve, whatever the scene assumes (behind).
#version 3.7;
global_settings { assumed_gamma 2.2 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 3*y direction -y right 4*x up 3*z }

#declare Plain = finish { ambient 0 diffuse 0 emission rgb 1 }
#for (I, 0, 7)
  box { <I / 2 - 2, 0, -1.5>, <I / 2 - 1.5, 0.1, 0> pigment { rgb (I + 1) / 9 } finish { Plain } }
  box { <I / 2 - 2, 0, 0>, <I / 2 - 1.5, 0.1, 1.5> pigment { srgb (I + 1) / 9 } finish { Plain } }
#end
