// Caustics on blended textures: each texture that has a share of a place stores a photon of its own, and so the nearest
// photons reach less far; what has less than the bail-out of a mesh or blob stores none (spec 07 3.6).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 photons { spacing 0.03 } }
camera { location <0, 4, -5> look_at <0, 0.3, 0> angle 45 }
light_source { <3, 6, -2> rgb 1 photons { reflection on refraction on } }
plane {
  y, 0
  texture {
    gradient x
    texture_map {
      [0 pigment { rgb <0.8, 0.7, 0.5> }]
      [0.6 average texture_map { [1 pigment { rgb 0.2 }] [2 pigment { rgb <0.3, 0.6, 0.4> } finish { reflection 0.2 }] }]
      [1 pigment { rgb <0.8, 0.7, 0.5> }]
    }
    scale 0.9
  }
}
sphere {
  <0.3, 1.2, 0>, 0.6 pigment { rgbf <1, 0.95, 0.9, 0.9> } finish { reflection 0.1 } interior { ior 1.4 }
  photons { target reflection on refraction on }
}
#declare Red = texture { pigment { rgb <0.9, 0.3, 0.2> } };
#declare Blue = texture { pigment { rgb <0.2, 0.3, 0.8> } };
#declare Grey = texture { pigment { rgb 0.6 } };
mesh { triangle { <-2.4, 0.1, -1>, <1, 0.1, -0.6>, <-0.4, 0.1, 1.4> texture_list { Red Blue Grey } } }
blob {
  threshold 0.3
  sphere { <-0.7, 0.1, 0.9>, 0.5, 1 texture { Red } } sphere { <-0.2, 0.1, 1>, 0.5, 1 texture { Grey } }
}
