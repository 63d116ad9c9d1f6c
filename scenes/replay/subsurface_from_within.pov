// Balls of clear and of fading glass that light scatters in: their far sides are seen from within.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 4 max_trace_level 3 subsurface { samples 8, 4 } }
camera { location <0, 0.5, -6> look_at 0 angle 35 }
light_source { <-3, 5, -4>, 1 }
background { rgb <0.1, 0.15, 0.3> }
#default { pigment { rgbt <0.6, 0.7, 0.5, 0.8> } finish { ambient 0 subsurface { translucency <2, 1.5, 1> } } }
sphere { <-1.2, 0, 0>, 1 interior { ior 1.3 } }
sphere { <1.2, 0, 0>, 1 interior { fade_power 2 fade_distance 0.5 } }
