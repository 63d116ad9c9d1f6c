// Shadow rays that come from as far as 1e9: the boxes around the light are met, or passed by, as the rounding of single
// precision has it, and an ovus or a splined sweep where the ray passes it by.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z look_at <0, -1.2, 0> angle 40 }
light_source { <0, 3, 0>, 0.9 }
box { -1e9, <1e9, 1e9, 1.01e9> pigment { rgb 1 } finish { ambient 0.1 diffuse 0.9 } }
ovus { 1, 0.5 no_image pigment { rgbf <1, 0.3, 0.3, 1> } }
ovus { 1, 0.5 rotate 30*x scale <0.7, 1, 0.4> translate 2*x no_image pigment { rgbf <0.3, 1, 0.3, 1> } }
box { <-4, -5, -4>, <4, 4, 5> no_image pigment { rgbf <0.5, 0.5, 1, 1> } }
sphere_sweep {
  b_spline 5, <-2, 0, 0>, 0.2, <-1, 1, 0>, 0.3, <1, 0, 0>, 0.2, <2, -1, 1>, 0.4, <3, 1, 0>, 0.2
  no_image
  pigment { rgbf <0.7, 0.7, 0.3, 1> }
}
