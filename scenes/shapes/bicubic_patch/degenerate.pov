// bicubic_patch of degenerate sizes
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
bicubic_patch { type 1 u_steps 3 v_steps 3 <0, 0, 0>, <0.2, 0, 0>, <0.4, 0, 0>, <0.6, 0, 0>, <0, 0, 0>, <0.2, 0, 0>, <0.4, 0, 0>, <0.6, 0, 0>, <0, 0, 0>, <0.2, 0, 0>, <0.4, 0, 0>, <0.6, 0, 0>, <0, 0, 0>, <0.2, 0, 0>, <0.4, 0, 0>, <0.6, 0, 0> texture { Coat } }
bicubic_patch { type 0 u_steps 3 v_steps 3 <-0, -0.75, 0>, <-0, -0.75, 0.3>, <0, -0.75, 0>, <0, -0.75, 0.3>, <-0.25, -0.25, 0>, <-0.0833333, -0.25, 0.3>, <0.0833333, -0.25, 0>, <0.25, -0.25, 0.3>, <-0.5, 0.25, 0>, <-0.166667, 0.25, 0.3>, <0.166667, 0.25, 0>, <0.5, 0.25, 0.3>, <-0.75, 0.75, 0>, <-0.25, 0.75, 0.3>, <0.25, 0.75, 0>, <0.75, 0.75, 0.3> texture { Coat } }
