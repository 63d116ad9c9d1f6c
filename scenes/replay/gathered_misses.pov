// Rays that radiosity gathers know by themselves whether their last search for an isosurface missed it, but where that
// was and what it saw is kept for all rays together (spec 04 6.3).
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 20 pretrace_end 0.02 } }
camera { location <1, 1, -4> look_at 0 }
background { rgb <0.25, 0.4, 0.6> }
isosurface { function { x*x + y*y + z*z - 1 } inverse pigment { rgb <1, 0.4, 0.25> } }
plane { y, -0.5 pigment { rgb 0.8 } }
