// Next to nothing to do: what starting and ending costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <3, 4, -9> rgb 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
