// With subsurface { radiosity on } the light around an object scatters in it as it comes from outside (spec 07 5.2), also
// for a camera within, whose rays have their samples on the other side.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 4, 3 radiosity on } radiosity { count 20 recursion_limit 1 } }
camera { location <0, 0.2, -0.5> look_at <0, 0, 2> angle 90 }
background { rgb <0.3, 0.5, 0.8> }
sphere { 0, 1.4 pigment { rgb 0.7 } finish { ambient 0.05 subsurface { translucency <0.9, 0.5, 0.3> } } }
