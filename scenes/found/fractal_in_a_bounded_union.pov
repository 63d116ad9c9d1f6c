// Within a union that is not dissolved a fractal goes on behind a hit that is too near, as within other CSG: what starts
// on its surface towards the light meets the rest of it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { ultra_wide_angle location <-4, 1, -4> }
light_source { <-10, 20, -30>, 1 }
union {
  julia_fractal { <-0.1, 0.6, 0, -0.3> max_iteration 5 }
  box { <-2, -1, 2>, <2, 1, 2.1> }
  bounded_by { sphere { 0, 5 } }
  pigment { rgb 1 }
}
