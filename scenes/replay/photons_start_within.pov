// Photons start in the interiors of all objects whose inside holds the light, beyond boxes, bounds and clips (the half
// space behind a disc, too), in the order of declaration (spec 07 3.5).
#version 3.7;
global_settings { assumed_gamma 1 photons { count 4000 } }
camera { location <0, 3, -7> look_at <0, 0.4, 0> angle 40 }
light_source { <-2, 6, -3>, 1 }
plane { y, -0.5 pigment { rgb 0.9 } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } };
disc { <-1.5, 1, 0>, -y, 1 pigment { rgbf 0.9 } interior { ior 1.5 } photons { target refraction on } }
box { <0.5, 0.9, -1>, <2.5, 1, 1> pigment { rgbf 0.9 } interior { ior 1.6 } photons { target refraction on } }
sphere { 0, 40 hollow texture { Clear } interior { ior 1.1 } no_image photons { pass_through } }
disc { <9, 2, 0>, -y, 0.01 texture { Clear } interior { ior 1.3 } photons { pass_through } }
sphere { <9, 2, 0>, 30 texture { Clear } interior { ior 1.25 } bounded_by { box { 9, 9.1 } } photons { pass_through } }
