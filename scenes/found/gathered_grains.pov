// All bits of the directions of gathered rays show: in a sky of grains of 1e-15, and where they leave a box by a wall
// that something taken away has in common with it (spec 07 2.7).
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity {
    recursion_limit 1 count 1 pretrace_start 1 pretrace_end 1
    error_bound 1e-5 minimum_reuse 1e-6 maximum_reuse 1e-5 nearest_count 1
  }
}
camera { location <0, 2, -6> look_at <0, 0.5, 0> right 4 / 3 * x }
sky_sphere {
  pigment { function { mod(abs(x + y + z) * 1e15, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
}
#default { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
plane { y, -1.5 }
sphere { <-2, 0, 1>, 0.8 }
difference {
  box { -1, 1 }
  prism { linear_spline -1, 0.5, 4, <-1, -1>, <1, -1>, <0, 1>, <-1, -1> }
  translate <1.5, 0, 0>
}
