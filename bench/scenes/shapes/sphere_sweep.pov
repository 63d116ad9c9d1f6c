// Worms along all three splines.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
sphere_sweep { linear_spline 6, <-3.5, 0, 0>, 0.3, <-3, 1.4, 0.5>, 0.4, <-2.4, 0, 0>, 0.3, <-1.8, 1.4, 0>, 0.25, <-1.4, -0.4, -0.3>, 0.35, <-2.4, -0.6, -1>, 0.2 pigment { rgb <0.8, 0.5, 0.4> } }
sphere_sweep { cubic_spline 8, <-1, -1, 0>, 0.2, <-0.8, 0, 0>, 0.3, <-0.2, 1.4, 0.6>, 0.35, <0.4, 0.2, -0.4>, 0.25, <0.8, 1.2, 0.2>, 0.35, <1.2, 0, 0>, 0.3, <0.2, -0.6, -0.8>, 0.25, <-0.6, -0.8, -1>, 0.2 pigment { rgb <0.4, 0.7, 0.4> } }
sphere_sweep { b_spline 8, <1.5, -1, 0>, 0.3, <1.9, 0, 0>, 0.5, <2.4, 1.9, 0.6>, 0.45, <2.9, 0.2, -0.4>, 0.4, <3.4, 1.9, 0.2>, 0.45, <3.7, 0, 0>, 0.4, <2.5, -0.9, -0.8>, 0.4, <1.6, -0.8, -1>, 0.3 pigment { rgb <0.4, 0.5, 0.9> } }
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
