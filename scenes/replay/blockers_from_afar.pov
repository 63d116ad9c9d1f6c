// Shadow rays from as far as 1e8 and what blocked the last of them, which is asked first: its box, in single precision,
// must begin before the light. Splined sweeps are met where the rays pass them by.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z look_at <0, -1.2, 0> angle 40 }
light_source { <0, 3, 0>, 0.9 }
box { -1e8, <1e8, 1e8, 1.01e8> pigment { rgb 1 } finish { ambient 0.1 diffuse 0.9 } }
ovus { 1, 0.5 translate -1.5*x no_image }
sphere_sweep { b_spline 5, <-2, 0, 0>, 1, <-1, 1, 0>, 1.5, <1, 0, 0>, 1, <2, -1, 1>, 2, <3, 1, 0>, 1 no_image }
