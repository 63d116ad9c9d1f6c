// substr from 0 is empty (spec 08 G).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

sphere { 0, 1 #if (strcmp(substr("abc", 0, 2), "") = 0) pigment { rgb x } #else pigment { rgb y } #end }
