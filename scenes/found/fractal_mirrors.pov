// A fractal that is a mirror, before a backdrop of grains of 1e-12, and one of glass: all bits of hits and normals show.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -6> look_at <0, 0, 0> angle 40 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#declare Fractal = julia_fractal { <-0.15, 0.4, -0.5, 0.1> quaternion sqr max_iteration 7 precision 25 slice <0.2, 0, -0.1, 1>, 0.05 }
object { Fractal pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } rotate 20 * y translate -1.3 * x }
object {
  Fractal pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 }
  rotate -50 * y scale <1, 0.8, 1.1> translate 1.3 * x
}
