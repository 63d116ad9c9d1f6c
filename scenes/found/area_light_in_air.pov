// Air takes its share of an area light once for all samples: of two corners along the last of them, of a finer grid along a
// ray to twice the position of the light. What is not hollow keeps it out where it is seen from within (spec 06 9.4).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> }
media { absorption <0.06, 0.08, 0.1> }
plane { y, -1 pigment { rgb 1 } }
box { <-1, 0, 0>, 1 pigment { rgb <1, 0.5, 0.2> } }
sphere { <1.6, 1, -2>, 0.7 pigment { rgbt <0.5, 1, 0.5, 0.7> } }
light_source { <3, 4, -6> rgb <1.5, 1.5, 0> media_attenuation on area_light 2*x, 2*z, 3, 3 adaptive 1 }
light_source { <-3, 4, -6> rgb <0, 0.5, 1> media_attenuation on area_light 2*x, z, 2, 2 }
