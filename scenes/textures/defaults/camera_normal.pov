// A camera's normal goes on from the default one: its transformation and turbulence stay.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { normal { bumps 0.4 turbulence 0.5 scale 3 } }
camera { location <0, 1, -6> look_at 0 normal { ripples 0.3 } }
light_source { <-4, 6, -9>, 1 }
sphere { 0, 1.5 pigment { rgb <1, 0.8, 0.3> } }
plane { y, -1.5 pigment { checker rgb 0.3, rgb 0.7 } }
