// See-through things before nothing, a half clear background, glints brighter than what they cover: the alpha channel
#ifndef (Background) #declare Background = 0; #end
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> right 4/3*x look_at 0 angle 45 }
light_source { <-4, 6, -5> rgb 1 }
#if (Background = 1) background { rgbt <0.2, 0.4, 0.6, 0.5> } #end
#if (Background = 2) background { rgbf <0.2, 0.4, 0.6, 0.5> } #end
#if (Background = 3) sky_sphere { pigment { gradient y color_map { [0 rgbt <0.9, 0.5, 0.2, 0.1>] [0.4 rgbt <0.2, 0.3, 0.9, 0.8>] } } } #end
sphere { <-1.2, 0.5, 0>, 0.9 pigment { rgbt <0.9, 0.3, 0.2, 0.6> } finish { phong 1 } }
sphere { <0, -0.5, 0.3>, 0.9 pigment { rgbf <0.3, 0.9, 0.3, 0.7> } finish { specular 2 roughness 0.01 reflection 0.2 } interior { ior 1.2 } }
box { -0.6, 0.6 rotate <20, 40, 0> translate <1.4, 0.3, 0> pigment { checker rgb <0.9, 0.8, 0.2>, rgbt 1 scale 0.3 } }
disc { <0, 1.2, 0>, z, 0.5, 0.3 pigment { rgb <0.2, 0.5, 1> } finish { ambient 0.6 } }
