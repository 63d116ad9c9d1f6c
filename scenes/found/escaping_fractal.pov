// Fractals of transcendental functions: their normals hang on iterates that the search left behind (spec 08 M).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <1, 2, -6> look_at 0 angle 50 }
light_source { <3, 5, -6>, 1 }
#declare Warm = texture { pigment { rgb <1, 0.7, 0.3> } finish { phong 0.5 } }
julia_fractal {
  <-0.3, -0.2, -0.25, -0.35> hypercomplex tan max_iteration 5 slice <0, 0, 0, 1>, 0.3
  texture { Warm } scale 0.5 translate x
}
intersection {
  julia_fractal { <-0.05, 0.6, -0.6, 0.5> hypercomplex acos max_iteration 8 precision 15 slice <0.1, 0.1, 0, 1>, 0 }
  box { <-3, -3, -3>, 3 }
  texture { Warm } scale 0.3 translate <-1, 0.5, 0>
}
