// A camera within three things of glass: which of them counts as the innermost hangs on the bounding hierarchy, which
// sorts them by their middles, not on their order in the file.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 0, -4> look_at 0 angle 60 }
sphere { 0, 30 hollow pigment { checker rgb 1 rgb x scale 3 } finish { ambient 1 diffuse 0 } }
#default { finish { ambient 0 diffuse 0 } }
box { -1, 1 pigment { rgbf <0.9, 1, 1, 1> } interior { ior 1.3 } translate <0.3, 0.2, -3.5> }
superellipsoid { <0.3, 0.3> pigment { rgbf <1, 0.9, 1, 1> } interior { ior 1.7 } scale 1.5 translate -4.2 * z }
sphere { <0.2, 0, -3.9>, 1.2 pigment { rgbf <1, 1, 0.9, 1> } interior { ior 2 } }
sphere { 3 * z, 0.5 pigment { rgb z } finish { ambient 1 } }
