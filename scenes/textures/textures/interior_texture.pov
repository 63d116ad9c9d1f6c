// interior texture (textures)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -4> direction 1.6*z right 1.3333*x up y look_at <0, 0.05, 0> }
light_source { <-4.3, 6.5, -5.6> rgb 1 }
light_source { <5, 3, -4> rgb 0.35 shadowless }
background { rgb <0.1, 0.15, 0.25> }

#declare Sample = texture {
  pigment { rgb 0.7 }
}
sphere { 0, 1 clipped_by { plane { <1, 0.4, 0.6>, 0.2 } } texture { pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.7 } } interior_texture { pigment { bozo scale 0.1 } normal { bumps 0.6 scale 0.1 } } }
plane { y, -1.037 pigment { checker rgb 0.4, rgb 0.7 } }
