// Rays along the axis of a conic prism pass its walls and meet the caps only (spec 03 4.17).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5 * y direction y up 3 * z right 4 * x }
#default { finish { ambient 1 diffuse 0 } pigment { gradient y color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.2, 0.3, 0.9>] } } }
prism { conic_sweep linear_spline 0.5, 1, 4 <-1, -1>, <1, -1>, <0, 1>, <-1, -1> translate -0.8 * x }
prism { conic_sweep quadratic_spline 0.5, 1, 5 <-1, -1>, <1, -1>, <0, 1>, <-1, -1>, <1, -1> scale 0.8 translate x }
prism { conic_sweep linear_spline 0.2, 1, 4 <-1, -1>, <1, -1>, <0, 1>, <-1, -1> open scale 0.5 translate <0, 0, 0.9> }
