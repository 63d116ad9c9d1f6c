#version 3.1;
#declare Sphere1 = sphere { <0,0,0>,1 }
union { object { Sphere1 material { texture { pigment { rgb <1,0,0> } } } scale 1.0 rotate <0,0,0> translate 0 } no_shadow }
