// lights: cylinder tightness
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.2, -7.5> look_at <0, 0.7, 0> angle 45 }
light_source { <-1, 5, -2> rgb 1 cylinder point_at <0, 0, 0> radius 0 falloff 3 tightness 3 }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.55, 0.6, 0.7> } }
sphere { <-1.5, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.5, 0.3> } finish { specular 0.5 roughness 0.02 } }
box { <0.6, 0, -0.5>, <1.7, 1.3, 0.6> rotate 15*y pigment { rgb <0.4, 0.7, 0.5> } finish { phong 0.4 } }
cone { <0, 0.02, -1.6>, 0.5, <0, 1.1, -1.6>, 0 pigment { rgbf <0.8, 0.8, 1, 0.6> } }
