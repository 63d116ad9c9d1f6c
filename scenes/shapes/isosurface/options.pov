// isosurface: open, threshold, sphere container, all_intersections
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
isosurface { function { sqrt(x*x + y*y) - 0.3 * cos(5 * z) } threshold 0.4 contained_by { sphere { 0, 1.1 } } open max_gradient 2 translate -1.1 * x texture { Coat } }
difference { isosurface { function { abs(x) + abs(y) + abs(z) - 1 } contained_by { box { -1, 1 } } max_gradient 1.8 all_intersections } cylinder { -2 * z, 2 * z, 0.3 } texture { Coat } rotate <20, 30, 0> translate 1.2 * x }
