// A torus far away, seen nearly along its axis: such a ray has to cross an end of the ring (spec 08 K).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.5 }
camera { location <0, 0, -2e5> right x*4/3 up y look_at 0 angle 7e-4 }
light_source { <1e5, 2e5, -5e5>, 1 }
torus { 0.7, 0.1 rotate -90*x pigment { rgb <1, 0.5, 0.2> } }
torus { 0.3, 0.06 rotate 88*x translate 0.2*x pigment { rgb <0.3, 0.5, 1> } }
