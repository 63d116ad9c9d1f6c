// A comma behind the only color of a reflection changes nothing (spec 06, 4.1).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 1, -6> look_at 0 }
light_source { <3, 5, -5>, 1 }
plane { y, -1 pigment { checker rgb <0, 0, 1> rgb <0.2, 0.9, 1> } }
sphere { -1.2*x, 1 pigment { rgb <1, 1, 0> } finish { reflection { 0.4, metallic } } }
sphere { 1.2*x, 1 pigment { rgb <1, 0.5, 0> } finish { reflection { rgb 0.6, fresnel } } interior { ior 1.4 } }
