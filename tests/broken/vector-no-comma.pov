// A mistake on purpose: vector no comma.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -5> look_at 0 }
light_source { <10, 20, -30>, rgb 1 }
box { <0, 0, 0> <1 1 1> pigment { rgb 1 } colour }
