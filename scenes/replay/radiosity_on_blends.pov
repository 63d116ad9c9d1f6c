// Each of blended textures asks for the radiosity at a point by itself, and may take a sample there (spec 07 2.4).
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 20 recursion_limit 1 } }
camera { location 0 }
light_source { <0, 0, -1> rgb 1 }
sphere {
  0, 1.5
  texture {
    gradient x
    texture_map { [0 pigment { rgb 1 } finish { diffuse 0.7 }] [1 pigment { rgb <1, 0.4, 0> } finish { diffuse 0.9 }] }
    scale 0.7
  }
}
