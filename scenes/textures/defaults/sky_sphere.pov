// #default does not reach the pigment of a sky sphere, of a pigment function or of a pigment pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { pigment { turbulence 0.4 color_map { [0 rgb x] [1 rgb z] } scale 3 } finish { ambient 1 diffuse 0 } }
#declare Of_function = function { pigment { gradient y } }
sky_sphere { pigment { gradient y } pigment { gradient x color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.5>] } } }
camera { location <0, 0.5, -6> look_at <0, 0.5, 0> }
sphere { <-2, 0, 0>, 0.9 pigment { pigment_pattern { gradient x } } }
sphere { 0, 0.9 pigment { rgb Of_function(0, 0.2, 0).x } }
sphere { <2, 0, 0>, 0.9 pigment { gradient x } }
