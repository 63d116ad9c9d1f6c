// Blocks and a table of the woods of woods.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "woods.inc"
camera { location <0, 4, -8> look_at <0, 0.5, 0> angle 45 }
light_source { <-20, 30, -30> rgb 1 }
plane { y, 0 texture { T_Wood7 scale 2 } }
box { <-3, 0, -1>, <-1, 2, 1> texture { T_Wood1 rotate 20*y } }
box { <-0.9, 0, -1>, <0.9, 1.5, 1> texture { T_Wood14 } }
cylinder { <2.2, 0, 0>, <2.2, 2, 0>, 1 texture { T_Wood23 rotate 80*x } }
sphere { <0, 1, 3.5>, 1 texture { T_Wood33 } }
