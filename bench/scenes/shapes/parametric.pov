// A torus knot's tube and a shell.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
parametric {
  function { (1 + 0.4 * cos(v)) * cos(u) } function { 0.4 * sin(v) } function { (1 + 0.4 * cos(v)) * sin(u) }
  <0, 0>, <2 * pi, 2 * pi> contained_by { box { <-1.5, -0.5, -1.5>, <1.5, 0.5, 1.5> } } max_gradient 1.5 accuracy 0.01 precompute 14 x, y, z
  rotate -40 * x translate <-1.6, 0.4, 0> pigment { rgb <0.8, 0.5, 0.4> }
}
parametric {
  function { u * cos(v) } function { 0.3 * sin(4 * u) } function { u * sin(v) }
  <0, 0>, <1.6, 2 * pi> contained_by { box { <-1.7, -0.4, -1.7>, <1.7, 0.4, 1.7> } } max_gradient 2 accuracy 0.01 precompute 14 x, y, z
  rotate -30 * x translate <1.9, 0.3, 0> pigment { rgb <0.5, 0.5, 0.9> }
}
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
