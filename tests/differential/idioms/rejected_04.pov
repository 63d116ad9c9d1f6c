#version 3.1;
#declare R1 = seed(0)
#declare A = rand(R1);
global_settings { assumed_gamma 2.2 max_trace_level 10 }
sphere { 0, 1 texture { pigment { color rgb<1,.5,0> } finish { ambient .1 diffuse .7 reflection .2 specular .5 roughness .01 } } halo { emitting } }
