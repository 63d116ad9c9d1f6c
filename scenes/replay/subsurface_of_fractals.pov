// Rays of subsurface light do not meet fractals nearer than 1e-4, though they do other shapes; their march ends there,
// too (spec 07 5.2).
#version 3.7;
global_settings { subsurface { } }
camera { location <0, 1, -6> rotate 10*y }
background { rgb <1, 0.25, 1> }
julia_fractal {
  <-0.2, 0.4, 0.3, -0.2> hypercomplex ln slice <0, 1, 0, 1>, 0
  pigment { rgb <0.6, 0.4, 0.2> } finish { ambient 0.25 diffuse 0.5 subsurface { translucency 0.5 } }
}
