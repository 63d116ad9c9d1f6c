// Raster3D r3dtogl / molscript -pov
#version 3.1;
global_settings { assumed_gamma 1.0 ambient_light rgb<0.5,0.5,0.5> max_trace_level 3 }
#declare R3D_AMBIENT = 0.05;
#declare R3D_DIFFUSE = 0.75;
camera { orthographic location <0.0, 0.0, -100.0> up <0,1,0> right <1.3333,0,0> direction z*1 look_at <0,0,0> angle 2 }
light_source { < 1.0e2, 1.0e2, -1.0e2 > color red 1.0 green 1.0 blue 1.0 }
background { color rgb <0.30, 0.32, 0.30> }
#macro MSPhere(P, R, C)
 sphere { P, R texture { pigment { C } finish { ambient R3D_AMBIENT diffuse R3D_DIFFUSE specular 0.25 roughness 0.05 } } }
#end
#macro MCyl(A,B,R,C) cylinder { A, B, R open texture { pigment { C } } } #end
#declare carbon = color rgb <0.2,0.2,0.2>;
#declare oxygen = color rgb <1,0,0>;
MSPhere(<-0.5,0,0>, 0.4, carbon)
MSPhere(<0.5,0.2,0>, 0.35, oxygen)
MCyl(<-0.5,0,0>,<0.5,0.2,0>, 0.12, carbon)
triangle { <-1,-1,1>, <1,-1,1>, <0,1.2,1> texture { pigment { color rgbt<0.3,0.5,0.9,0.4> } } }
smooth_triangle { <-1,-1,.5>, <0,0,-1>, <0,-1,.5>,<0,0.2,-1>, <-.5,0.1,.5>,<0.3,0,-1> pigment { oxygen } }
