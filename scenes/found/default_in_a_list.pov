// #default in the midst of lists and statements: what a list lacks is the default that holds at its end.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { -10*z, rgb 1 }
plane { y, -1 pigment { brick pigment { rgb 1 }, #default { finish { specular 0 } pigment { rgb 0.5 } } } }
sphere { 0, 1 normal { checker normal { bumps } normal { #default { normal { dents } } wrinkles } } pigment { #default { pigment { rgb x } } rgb 1 } }
box { -1, 1 texture { checker texture { pigment { rgb y } } #default { texture { pigment { rgb z } } } } }
#declare F = finish { #default { finish { phong 1 } } diffuse 0.5 }
