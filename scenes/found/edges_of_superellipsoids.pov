// Normals on the edges of superellipsoids with an exponent of 2, which lie in the planes of coordinates (spec 03 4.12).
// At an odd width and height rays meet them.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { emission 1 diffuse 0 } }
camera { orthographic location <0, 0, -6> look_at 0 right 4.4 * x up 3.3 * y }
superellipsoid { <2, 0.25> pigment { slope x } }
