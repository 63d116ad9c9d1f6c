// finish: phong small
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -6> look_at <0, 0.75, 0> angle 45 }
light_source { <-4, 6, -5> rgb 0.9 }
light_source { <5, 3, -2> rgb <0.3, 0.35, 0.5> }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.55, 0.6, 0.7> } }
#declare Coat = texture { pigment { rgb <0.85, 0.55, 0.25> } finish { phong 0.9 phong_size 5 } }
sphere { <-1.1, 0.95, 0>, 0.95 texture { Coat } }
box { -0.65, 0.65 rotate <15, 35, 0> translate <1.2, 0.95, 0.1> texture { Coat } }
