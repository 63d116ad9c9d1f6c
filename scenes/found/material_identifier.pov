// A material identifier adds its layers, and replaces the interior: by none, if it has none (spec 08 E).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

plane { z, 3 pigment { checker rgb <1, 0.3, 0.3> rgb <0.3, 0.3, 1> } }
#declare Tinted = material { texture { pigment { rgbt <0.3, 1, 0.3, 0.5> } } }
#declare Glass = material { interior { ior 1.3 } }
sphere { <-1.5, 0, 0>, 0.6 pigment { rgbt 1 } interior { ior 1.6 } material { Tinted } }
sphere { <0, 0, 0>, 0.6 pigment { rgbt <1, 0.4, 0.4, 0.6> } material { Glass } }
sphere { <1.5, 0, 0>, 0.6 texture { pigment { rgbt <0.3, 0.3, 1, 0.6> } } material { Tinted interior { ior 1.2 } } }
sphere { <0, 1.3, 0>, 0.6 pigment { rgbt 1 } interior { ior 1.5 } material { texture { pigment { rgbt <1, 1, 0.3, 0.6> } } } }
