// The shadow of a letter that its text's bounds cut: what shadows remember is the letter, which has no bounds.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4.4, 10, 0> direction -y up 5*z right 6.67*x }
plane { y, 0 pigment { rgb 1 } finish { ambient 0.2 diffuse 0.6 } }
light_source { <3, 32, -23>, rgb 1 }
text { ttf "timrom.ttf" "HM" 1, 0 translate <3.75, 2, -2> pigment { rgb x } bounded_by { box { <3.5, 1, -3>, <4.9, 4, 0> } } }
