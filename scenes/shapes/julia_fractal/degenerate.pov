// julia_fractal of degenerate sizes
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
julia_fractal { <0, 0, 0, 0> quaternion sqr max_iteration 3 precision 20 scale 0.6 translate -1.2 * x texture { Coat } }
julia_fractal { <-0.162, 0.163, 0.56, -0.599> quaternion cube max_iteration 1 precision 1 scale 0.6 translate 1.2 * x texture { Coat } }
