// Mirrors in each other: adc_bailout asks for fresnel's reflectivity before metallic tints it.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <6, 5, -9> look_at 0 angle 30 }
sky_sphere { pigment { gradient y color_map { [0 rgb <1, 0.5, 0>] [1 rgb <0, 0.5, 1>] } } }
plane { y, 0 pigment { rgb 0.5 } finish { reflection { 0.29, 0.3 fresnel metallic } } }
sphere { y*1.2, 1 pigment { rgb 0.7 } finish { reflection { 0.1, 0.6 fresnel } } }
