// What radiosity sees behind a pane is seen as by an image ray, so that the no_image floor is not there; in a mirror what is
// marked no_radiosity is not there, either (spec 07 2.2).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 radiosity { count 40 recursion_limit 1 } }
camera { location <0, 1, -6> }
light_source { <3, 4, -6> rgb 1 }
box { <-1, 0, -1>, <1, 3, 0> pigment { rgb 1 } }
box { <-3, -0.5, -3>, <3, -0.4, 3> pigment { rgbt <1, 1, 1, 0.9> } no_shadow }
sphere { <2, 1.2, -1>, 0.9 pigment { rgb 0.1 } finish { reflection 0.9 } }
plane { y, -1 pigment { rgb <1, 0.5, 0.2> } no_image }
plane { z, 3 pigment { rgb <0.3, 0.5, 1> } no_radiosity }
