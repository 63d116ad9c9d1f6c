// Grains (crand) beside things that radiosity gathers light for: gathered rays read random streams of their own and
// have a shadow cache of their own, whatever their depth (spec 07 1).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 radiosity { recursion_limit 3 } }
camera { location <0, 0.3, -8> look_at <0, 0.2, 0> angle 40 }
light_source { <0, 1.4, -1> rgb 0.7 }
plane { y, 0 pigment { rgb <0.7, 0.6, 0.5> } finish { crand 0.2 } }
#for (I, -3, 3)
  sphere { <0.6*I, 0.3, 0.2*I*I - 1>, 0.3 pigment { rgb <0.9, 0.5 + I/8, 0.2> } }
#end
box { -0.4, 0.4 rotate 25*y translate <-1.9, 0.4, 1.3> pigment { rgb 0.3 } finish { reflection 0.4 crand 0.1 } }
