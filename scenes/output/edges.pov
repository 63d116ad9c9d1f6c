// Edges of every contrast: what anti-aliasing, regions, quality levels and the order of blocks are judged by
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 1.5, -5> right 4/3*x look_at <0, 0.6, 0> angle 50 }
light_source { <-4, 6, -5> rgb 1 area_light 2*x, 2*y, 3, 3 }
light_source { <5, 3, -4> rgb 2 spotlight point_at <1.2, 0, 0> radius 10 falloff 12 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.8, 0.7>] [0.5 rgb <0.2, 0.4, 0.8>] } } }
fog { distance 40 rgb 0.6 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.25, 0.4> scale 0.5 quick_color rgb <0.3, 0.6, 0.3> } }
sphere { <-1.2, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.4, 0.2> } normal { bumps 0.3 scale 0.2 } finish { phong 1 reflection 0.3 } }
sphere { <0.4, 0.5, -1.2>, 0.5 pigment { rgbf <0.9, 1, 0.9, 0.9> } finish { reflection 0.1 specular 3 roughness 0.005 } interior { ior 1.4 } }
torus { 0.6, 0.03 rotate 70*x translate <1.3, 0.9, 0> pigment { rgb <0.9, 0.8, 0.1> } finish { ambient 4 } }
#declare I = 0;
#while (I < 9)
  cylinder { <0.8 + 0.12*I, 0, 1>, <0.8 + 0.14*I, 1.8, 1.4>, 0.02 pigment { rgb <mod(I, 2), 0.5, 0.2> } }
  #declare I = I + 1;
#end
