// prism of a bezier spline swept to a point
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
object { prism { conic_sweep bezier_spline 0.3, 1, 8, <0, -1>, <1.6, -0.6>, <0.8, 1>, <0, 1>, <0, 1>, <-0.8, 1>, <-1.6, -0.6>, <0, -1> } texture { Coat } rotate 180 * x translate y * 0.6 scale 0.9 translate -1.1 * x }
object { prism { conic_sweep bezier_spline -0.5, 0.8, 8, <0, -1>, <1.6, -0.6>, <0.8, 1>, <0, 1>, <0, 1>, <-0.8, 1>, <-1.6, -0.6>, <0, -1> open } texture { Coat } rotate -50 * x scale 0.9 translate 1 * x }
