// Prisms in the same place as a plane: which is seen hangs on the last bit of their depths, and they have a
// matrix of their own even where none is written (spec 08 B).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.4, 7, -12> look_at <0, 0, 1> angle 40 }
#default { finish { ambient 1 diffuse 0 } }
plane { y, 0 pigment { rgb <1, 0.4, 0.3> } }
prism { -1, 0, 5 <-4, -2>, <-1, -2>, <-1, 2>, <-4, 2>, <-4, -2> pigment { rgb <0.3, 0.8, 0.3> } }
prism { bezier_spline -1, 0, 8 <1, 0>, <1, 2>, <4, 2>, <4, 0>, <4, 0>, <4, -2>, <1, -2>, <1, 0> pigment { rgb <0.3, 0.4, 1> } }
