// What a light in CSG looks like is asked as all other parts are, as far as it may be: what rounding moves before a sor
// comes before what is met sooner.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -6*z right 16*x up 12*y normal { bumps 0.005 } }
#default { pigment { gradient z scale 8 translate -4*z } finish { ambient 1 diffuse 0 } }
#declare Vase = light_source { 0 rgb 0 looks_like { sor { 5 <0, -1> <1, -2> <1, 0> <0, 1> <0, 1> } } }
#declare Ring = torus { 2, 1 }
union { object { Ring } object { Vase } clipped_by { box { -7, 7 } } translate <-4, 3, 0> }
union { union { object { Vase } object { Ring } } sphere { 2*y, 0.3 } bounded_by { box { -7, 7 } } translate <4, 3, 0> }
union { object { Ring } cylinder { -y, y, 2.5 } object { Vase rotate 90*z } clipped_by { box { -7, 7 } } translate <-4, -3, 0> }
intersection { union { object { Ring } object { Vase } } box { -7, 7 } translate <4, -3, 0> }
