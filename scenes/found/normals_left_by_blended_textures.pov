// `slope` and `aoi` as patterns of a normal's map see the normal that the evaluation before has left: of the texture
// before in a blob, of the map's entry or of the layer (spec 05 3.4).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0.2, 0> angle 55 }
light_source { <3, 4, -6>, 1 }
#default { finish { specular 0.7 diffuse 0.6 } }
#declare Steep = normal { slope { <1, 1, 0> altitude y, -1, 1 } normal_map { [0 bumps scale 0.3] [1 wrinkles] } }
#declare Seen = normal { aoi normal_map { [0.5 ripples 0.6 scale 0.2] [0.8 bumps 0.8 scale 0.1] } }
blob {
  threshold 0.3
  sphere { <0, -0.5, 0>, 2, 1 }
  sphere { <-1, 0, -1>, 1, 1 }
  sphere { <-0.5, 0, 1>, 2, 1 pigment { rgb <0.9, 0.5, 0.3> } }
  pigment { rgb 0.5 }
  normal { Steep }
  translate -1.6 * x
}
sphere {
  <1.5, 0.4, 0>, 1.2
  texture { gradient y texture_map { [0 pigment { rgb 0.6 } normal { Steep }] [1 pigment { rgb x } normal { Seen }] } }
}
plane {
  y, -1.2
  texture { pigment { rgb <0.2, 0.4, 0.6> } normal { Seen } }
  texture { pigment { rgbt <0.8, 0.9, 0.4, 0.5> } normal { bumps 0.5 scale 0.4 } }
}
plane { -z, -5 pigment { rgb 0.6 } normal { gradient x normal_map { [0 bumps] [1 Steep] } scale 0.7 } }
