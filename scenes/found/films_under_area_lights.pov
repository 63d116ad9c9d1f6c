// Where an area light with area_illumination shines from every place of its grid, an iridescent film is tinted by the
// direction of its centre (spec 06 8.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at <0, 0.2, 0> angle 50 }
light_source { <1, 3, -2>, 1 area_light 2 * x, 2 * z, 3, 2 area_illumination }
#default { finish { irid { 0.4 thickness 0.5 turbulence 0.1 } specular 0.3 } }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgb <0.5, 0.6, 0.7> } }
box { <0.3, -1, -0.5>, <1.6, 0.6, 0.8> pigment { rgb 0.7 } rotate 20 * y }
plane { y, -1 pigment { checker rgb 1 rgb 0.5 } }
