// height tiling 10 (normals)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -4> direction 1.6*z right 1.3333*x up y look_at <0, 0.05, 0> }
light_source { <-4.3, 6.5, -5.6> rgb 1 }
light_source { <5, 3, -4> rgb 0.35 shadowless }
background { rgb <0.1, 0.15, 0.25> }

#declare Sample = texture {
  pigment { rgb <0.85, 0.8, 0.7> } normal { tiling 10 scale 0.3 rotate <-25, 10, 5> } finish { phong 0.5 phong_size 20 }
}
sphere { <-1.05, 0, 0>, 0.95 texture { Sample } }
box { -0.72, 0.72 rotate <0, 35, 0> translate <1.05, -0.1, 0.1> texture { Sample } }
plane { y, -1.037 texture { Sample } }
