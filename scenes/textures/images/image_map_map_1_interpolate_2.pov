// image map map 1 interpolate 2 (images)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -4> direction 1.6*z right 1.3333*x up y look_at <0, 0.05, 0> }
light_source { <-4.3, 6.5, -5.6> rgb 1 }
light_source { <5, 3, -4> rgb 0.35 shadowless }
background { rgb <0.1, 0.15, 0.25> }

#declare Sample = texture {
  pigment { image_map { ppm "../data/small.ppm" map_type 1 interpolate 2 }  }
}
sphere { <-1.05, 0, 0>, 0.95 texture { Sample } }
box { -0.72, 0.72 rotate <0, 35, 0> translate <1.05, -0.1, 0.1> texture { Sample } }
plane { y, -1.037 texture { Sample } }
