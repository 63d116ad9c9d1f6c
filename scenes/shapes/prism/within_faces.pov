// Prisms whose edges lie exactly where rays go.
#version 3.7;
global_settings { assumed_gamma 1 }
// Pixel centres are multiples of 1/2 at 160x120: some rays run exactly within the faces of boxes.
camera { orthographic location <0.25, 0.25, -100> right 80*x up 60*y look_at <0.25, 0.25, 0> }
background { rgb <0.1, 0.2, 0.3> }
#default { finish { ambient 0.7 diffuse 0.3 } }
light_source { <30, 50, -100>, rgb 1 }
prism { 10, 20, 4, <-30, -3>, <-20, 0>, <-30, 3>, <-30, -3> pigment { rgb <1, 0.6, 0.4> } }
prism { 10, 20, 5, <-10, -3>, <0, -3>, <0, 3>, <-10, 3>, <-10, -3> pigment { rgb <0.5, 1, 0.4> } }
prism { 10, 20, 5, <10, 0>, <15, -3>, <20, 0>, <15, 3>, <10, 0> pigment { rgb <0.5, 0.6, 1> } }
prism { -0.5, 0.5, 4, <-1, -0.3>, <1, 0>, <-1, 0.3>, <-1, -0.3> scale 12 translate -15*x pigment { rgb <1, 1, 0.4> } }
prism { -10, -5, 4, <1, 0>, <2, 3>, <2, -3>, <1, 0> scale <12, 1, 1> translate 2*x pigment { rgb <1, 0.4, 1> } }
