// The same through a material that is moved, and through a mesh.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

sphere { <-0.8, 0, 0>, 0.7 material { texture { pigment { rgb 1 } } rotate 30*z } pigment { checker rgb x rgb 1 scale 0.3 } }
mesh { triangle { <0, -1, 0>, <2, -1, 0>, <1, 1, 0> } pigment { rgb 1 } scale <0.9, 1.3, 1> rotate 10*z pigment { checker rgb z rgb 1 scale 0.3 } }
