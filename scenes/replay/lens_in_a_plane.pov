// A lens that reaches into what is not hollow: with cameras other than perspective ones what the first ray starts in
// counts for all rays, behind the glass around the camera, too (spec 02 1.8).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { ultra_wide_angle aperture 0.2 blur_samples 4 right x * 4/3 }
fog { distance 10 rgb <0.6, 0.5, 1> }
plane { y, 0 pigment { rgb 1 } finish { ambient 1 } }
sphere { 0, 0.3 pigment { rgbt 1 } }
