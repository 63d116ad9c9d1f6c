// Light of media is asked for from as far as 2e10, where boxes and containers are met by rounding: an isosurface is
// searched there, and forgets what it missed (spec 04 6.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6 * z angle 40 look_at <0, 0.5, 0> }
light_source { <3, 4, -6>, 1 }
media { scattering { 1, 0.02 } }
isosurface { function { x * x + y * y + z * z - 1 } contained_by { sphere { 0, 1.4 } } pigment { rgb <1, 0.8, 0.3> } }
