// What a fractal in CSG is hit at behind its first hit counts as nearer than it is: here as nearer than the edge of the
// ball before it, though its box begins further away.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z angle 38 }
light_source { -20*z, 1 }
sphere { <1, 0, 0>, 0.4 pigment { rgb z } }
difference {
  torus { 1.5, 1 clipped_by { plane { -z, 0 } } }
  julia_fractal { <-0.1, 0, 0, -0.3> hypercomplex max_iteration 3 }
  pigment { rgb <1, 1, 0> }
}
