// two solids with a face in common: boxes in a union, an intersection and a merge
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.31, 1.47, -6.13> look_at <0.02, 0.01, 0> angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
union { box { <-1, -0.5, -0.5>, <0, 0.5, 0.5> pigment { rgb <1, 0.4, 0.3> } } box { <0, -0.5, -0.5>, <0.7, 0.5, 0.5> pigment { rgb <0.3, 0.5, 1> } } translate <-0.6, 0.9, 0> }
intersection { box { <-0.8, -0.5, -0.5>, <0.6, 0.5, 0.5> pigment { rgb <1, 0.4, 0.3> } } box { <-0.6, -0.5, -0.7>, <0.8, 0.4, 0.5> pigment { rgb <0.3, 0.5, 1> } } translate <-0.9, -0.7, 0> }
merge { box { <-0.8, -0.5, -0.5>, <0, 0.5, 0.5> pigment { rgb <1, 0.4, 0.3> } } box { <-0.2, -0.3, -0.7>, <0.8, 0.4, 0.5> pigment { rgb <0.3, 0.5, 1> } } translate <1.1, -0.7, 0> }
