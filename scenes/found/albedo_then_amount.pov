// `albedo` counts for all amounts of its kind in a finish; one color after a reflection with fresnel keeps its minimum.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 1, -6> look_at 0 }
light_source { <3, 5, -5>, rgb 0.4 }
plane { y, -1 pigment { checker rgb <0, 0, 1> rgb <0.2, 0.9, 1> } finish { diffuse albedo 0.8 brilliance 2 diffuse 0.4 } }
sphere { -2.2*x, 1 pigment { rgb <1, 1, 0> } finish { specular albedo 0.5 specular 0.2 } }
sphere { 0, 1 pigment { rgb <1, 0.5, 0> } finish { phong albedo 0.3 phong 0.1 } }
sphere { 2.2*x, 1 pigment { rgb 0.1 } finish { reflection { 0, 1 fresnel } reflection { 0.4 } } interior { ior 1.5 } }
