// Rays of subsurface scattering meet blobs nearer than 0.01, which others do not (spec 07 5.2), in CSG, too.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 20, 10 } }
camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <3, 4, -6>, 1 }
background { rgb 0.1 }
#default { pigment { rgb <1, 0.8, 0.3> } finish { specular 0.3 subsurface { translucency 2 } } }
merge { blob { threshold 0.4 sphere { 0, 1.2, 1 } } sphere { <0, -1, 0>, 0.4 } translate -1.3*x }
intersection { blob { threshold 0.4 sphere { 0, 1.2, 1 } sphere { y/2, 1, 0.7 } } box { -1, <1, 0.6, 1> } translate 1.3*x }
