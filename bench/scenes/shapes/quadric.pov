// Paraboloids, hyperboloids and an ellipsoid, cut to size.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 clipped_by { plane { y, 2 } } translate <-2.4, -1, 0> pigment { rgb <0.8, 0.5, 0.4> } }
quadric { <1, -1, 1>, 0, 0, -0.2 clipped_by { box { <-2, -1.2, -2>, <2, 1.2, 2> } } pigment { rgb <0.5, 0.8, 0.4> } }
quadric { <1, 0.3, 1>, 0, 0, -1 translate <2.5, 0.5, 0> pigment { rgb <0.5, 0.5, 0.9> } }
quadric { <1, 0, -1>, 0, <0, 1, 0>, 0 clipped_by { box { <-1.5, -1, -1.5>, <1.5, 1, 1.5> } } translate <0.5, 0, 2.5> pigment { rgb <0.9, 0.8, 0.4> } }
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
