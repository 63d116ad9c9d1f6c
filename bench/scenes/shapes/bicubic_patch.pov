// Waving flags of bicubic patches.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare Flag = bicubic_patch {
  type 1 flatness 0.01 u_steps 4 v_steps 4
  <-1.5, -1, 0>, <-0.5, -1, 1.2>, <0.5, -1, -1.2>, <1.5, -1, 0>, <-1.5, -0.3, 0.4>, <-0.5, -0.3, -1.4>, <0.5, -0.3, 1.4>, <1.5, -0.3, 0.3>,
  <-1.5, 0.3, 0>, <-0.5, 0.3, 1.2>, <0.5, 0.3, -1.5>, <1.5, 0.3, 0.4>, <-1.5, 1, -0.3>, <-0.5, 1, 0>, <0.5, 1, 1>, <1.5, 1, 0>
}
object { Flag translate <-1.8, 0.4, 0> pigment { rgb <0.8, 0.3, 0.3> } }
object { Flag rotate 30 * y translate <1.8, 0.4, 0> pigment { rgb <0.3, 0.5, 0.9> } }
object { Flag scale 1.5 translate <0, 1.4, 3> pigment { rgb <0.4, 0.8, 0.4> } }
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
