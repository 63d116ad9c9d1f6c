// Modifiers behind the object in looks_like come when it is at the light's place already: those that move it, and
// patterns that take the place of a solid colour, which has gone that way.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.6, -4> look_at 0 angle 50 }
light_source { <3, 6, -8> rgb 1 }
#declare B = sphere { 0, .6 pigment { rgb x } };
#declare U = union { sphere { 0, .3 } box { -.1,<.5,.1,.1> } pigment { rgb y } };
light_source { <0.5, -0.8, 0> rgb 0 looks_like { B scale .8 } }
light_source { <-0.5, 0.4, 0> rgb 0 looks_like { B scale <.5,1.5,1> rotate 30*z pigment { gradient x } } translate .2*x }
light_source { <-1, -0.4, 0.3> rgb 0 looks_like { U rotate 40*z translate .1*y } }
light_source { <1, 0.6, 0.3> rgb 0 looks_like { sphere { 0,.3 translate .1 } rotate 40*z translate .1*y } rotate 10*y }
plane { y, -1.5 pigment { checker rgb 1 rgb 0.5 } }
