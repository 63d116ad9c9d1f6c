// parametric with uv_mapping
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare S = parametric {
  function { (1 + 0.35 * cos(v)) * cos(u) } function { 0.35 * sin(v) } function { (1 + 0.35 * cos(v)) * sin(u) }
  <0, 0>, <2 * pi, 2 * pi> contained_by { box { <-1.4, -0.4, -1.4>, <1.4, 0.4, 1.4> } }
  max_gradient 1.4 accuracy 0.01 precompute 12 x, y, z
}
object { S pigment { uv_mapping checker rgb 1, rgb <0.2, 0.4, 0.9> scale 0.15 } rotate <15, 20, 0> }
