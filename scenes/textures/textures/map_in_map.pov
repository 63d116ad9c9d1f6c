// map in map (textures)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -4> direction 1.6*z right 1.3333*x up y look_at <0, 0.05, 0> }
light_source { <-4.3, 6.5, -5.6> rgb 1 }
light_source { <5, 3, -4> rgb 0.35 shadowless }
background { rgb <0.1, 0.15, 0.25> }
#declare Layered = texture { pigment { wood scale 0.2 } } texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgb <0.2, 0.3, 0.7>] } scale 0.15 } }
#declare Mapped = texture { gradient x texture_map { [0.4 pigment { rgb <1, 0.4, 0.2> }] [0.6 pigment { granite scale 0.4 } finish { phong 0.6 }] } scale 0.5 }
#declare Sample = texture {
  gradient x texture_map { [0.3 Mapped] [0.7 Layered] } scale 0.8
}
sphere { <-1.05, 0, 0>, 0.95 texture { Sample } }
box { -0.72, 0.72 rotate <0, 35, 0> translate <1.05, -0.1, 0.1> texture { Sample } }
plane { y, -1.037 texture { Sample } }
