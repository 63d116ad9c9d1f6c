// Up to version 3.1 layers above the bottom one transmit what they were told to filter. A plain color that takes the
// place of the default pigment's map leaves that map, and all that share it, alone (spec 05 11.2).
#version 3.1;
global_settings { assumed_gamma 1 }
#default { pigment { checker pigment { rgb <0.9, 0.1, 0> } pigment { rgbf <1, 0.9, 0, 0.5> } scale 0.4 } }
background { rgb <0, 0.5, 0.9> }
camera { location <0, 3, -6> look_at <0, 0.5, 0> angle 45 }
light_source { <5, 9, -5>, 1 }
cylinder { <-1.2, -0.2, -0.5>, <-1, 2, 0>, 0.8 }
sphere { <1.1, 0.7, 0>, 0.9 }
plane { y, -0.5 texture { } texture { pigment { rgbf <0.3, 0.4, 0.3, 0.4> } } }
