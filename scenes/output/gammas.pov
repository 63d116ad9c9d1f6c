// Colours under the assumed_gamma that the switch Declare=Gamma=... chooses (0: none, -1: srgb)
#version Language;
#if (Gamma > 0) global_settings { assumed_gamma Gamma } #end
#if (Gamma < 0) global_settings { assumed_gamma srgb } #end
camera { location <0, 1.2, -4> right 4/3*x look_at <0, 0.4, 0> angle 50 }
light_source { <-4, 6, -5> rgb <1, 0.9, 0.8> }
background { rgb <0.1, 0.2, 0.4> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.7>, rgb <0.05, 0.1, 0.05> } }
sphere { <-0.7, 0.6, 0>, 0.6 pigment { gradient y color_map { [0 rgb <1, 0, 0>] [0.5 rgb <0.1, 0.3, 0.05>] [1 rgb <0, 0, 1>] } scale 1.2 } finish { phong 0.6 } }
sphere { <0.8, 0.5, -0.3>, 0.5 pigment { rgbf <0.9, 0.6, 0.3, 0.8> } finish { reflection 0.2 } }
