// The normals of a uv-mapped texture go with what moves the texture as a whole (spec 08 I).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0.5, 1.5, -5> look_at <0.5, 0.4, 0> angle 35 }
light_source { <-3, 4, -8>, 1 }
#declare Bumpy = texture { uv_mapping pigment { rgb <1, 0.8, 0.5> } normal { bumps 0.5 scale 0.1 } }
box { 0, 1 texture { Bumpy } rotate 35*y translate -0.7*x }
box { 0, 1 texture { Bumpy } scale <0.6, 1.4, 0.8> rotate <0, 30, 10> translate 1*x }
