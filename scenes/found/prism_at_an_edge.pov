// Rays through an edge of a prism that is an edge of its box, too: the boxes around several objects end before it.
#version 3.0;
global_settings { assumed_gamma 1 }
camera { orthographic location <-3, 3, -9> look_at <0, 1, 0> right 16*x up 12*y }
background { rgb <0.2, 0.3, 0.5> }
light_source { <-8, 22, -35> rgb 1 shadowless }
prism { linear_spline 0, 0.5, 5, <-1, -1>, <1, -1>, <1, 1>, <0, 0.4>, <-1, -1> translate <3, 0.75, 2.25> pigment { rgb <1, 0.6, 0.4> } }
sphere { 0, 0.1 }
sphere { -2*x, 0.1 }
sphere { -2*z, 0.1 }
