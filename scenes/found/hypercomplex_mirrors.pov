// Fractals of hypercomplex squares that are mirrors, before a backdrop of grains of 1e-12: all bits of hits and normals
// show (spec 08 M).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -6> look_at <0, 0, 0> angle 40 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#default { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
#declare Slice = <0.2, 0, -0.1, 1>;
julia_fractal {
  <-0.1, 0.6, 0.2, -0.3> hypercomplex sqr max_iteration 5 precision 25 slice Slice, 0.05
  rotate 20 * y translate -1.3 * x
}
julia_fractal {
  <-0.1, 0.6, 0.2, -0.3> hypercomplex cube max_iteration 5 precision 25 slice Slice, 0.05
  rotate 20 * y translate 1.3 * x
}
