// Walls of prisms in a plane and in a triangle: which of them is nearer hangs on the last bit of the direction, which
// focal blur normalises twice (spec 08 B).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 aperture 0.2 blur_samples 4 focal_point 0 }
#default { finish { ambient 1 } }
plane { z, -1 pigment { rgb y } }
prism { linear_spline 0, 1, 4, <-1, -1>, <1, -1>, <0, 1>, <-1, -1> pigment { rgb x } }
prism { linear_spline -1.5, -0.5, 4, <-2, -1.2>, <2, -1.2>, <0, 1>, <-2, -1.2> pigment { rgb x } }
triangle { <-2, -1.5, -1.2>, <2, -1.5, -1.2>, <0, 0.5, -1.2> pigment { rgb <0, 0.5, 1> } }
