// Samples whose normal is the opposite of the asking one are not taken, however wide the bound of errors is: of two on
// both sides of a pane each lights its own (spec 07 2.5).
#version 3.7;
global_settings { assumed_gamma 1 radiosity { pretrace_start 1 pretrace_end 1 } }
camera { location <0, 0.5, -4> }
plane { z, -2 pigment { rgbt <1, 1, 1, 0.6> } finish { reflection 0.2 } }
plane { y, -1 pigment { rgb 1 } }
