// Mirrors before a backdrop of grains of 1e-13: isosurfaces, one cut by a sphere, and a parametric surface.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e13, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#default { pigment { rgb 0 } finish { reflection 1 } }
isosurface {
  function { x*x + y*y + z*z - 1 + 0.2*sin(5*x)*sin(5*y) }
  contained_by { box { -1.3, 1.3 } }
  max_gradient 4
  translate <-1.5, 0, 0>
}
isosurface {
  function { x*x + z*z - 0.5 + 0.1*sin(5*y) }
  contained_by { sphere { <0.1, 0.2, 0>, 1.2 } }
  max_gradient 4
  translate 1.5*x
}
parametric {
  function { u } function { v } function { u*v } <-1, -1>, <1, 1>
  contained_by { box { -1.1, 1.1 } }
  translate <0, 0, 1.5>
}
