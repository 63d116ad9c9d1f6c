// hypercomplex Julia fractals of several functions
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
julia_fractal { <-0.1, 0.1, -0.7, 0.05> hypercomplex sqr max_iteration 7 precision 30 scale 0.8 translate -1.2 * x texture { Coat } }
julia_fractal { <-0.2, 0.2, -0.5, 0.1> hypercomplex cube max_iteration 5 precision 20 scale 0.6 translate 1.2 * x texture { Coat } }
