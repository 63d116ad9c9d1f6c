// objects seen only in a mirror, or never in it
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
box { <-2.4, -1.5, 2>, <2.4, 1.8, 2.2> pigment { rgb 0.1 } finish { reflection 0.8 ambient 0 diffuse 0.2 } }
sphere { <-1.2, 0, 0>, 0.6 no_image texture { Coat } }
sphere { <0.1, 0, 0>, 0.6 no_reflection texture { Coat } }
union { box { <0.9, -0.5, -0.4>, <1.7, 0.4, 0.4> no_image } sphere { <1.3, 0.7, 0>, 0.3 no_reflection } split_union off texture { Coat } }
