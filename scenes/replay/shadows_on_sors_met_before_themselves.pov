// Rays that hardly rise meet a sor before and behind itself, by the rounding of its formula. Those towards the light
// that start there may have left its box before the distance from which on a shadow counts; they meet it all the same.
#version 3.7;
camera { orthographic location -5*z aperture 0.02 blur_samples 4 }
light_source { -10*z, 0.8 }
sor { 5 <0, -1> <0.5, -0.8> <1, 0> <0.3, 0.8> <0, 1> pigment { rgb x } }
julia_fractal { <0, 1, 0, 0> }
