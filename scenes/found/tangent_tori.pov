// Rays that touch tori: where a discriminant of the quartic is exactly 0 its double root is misplaced, and along the
// axis a ray on the rim of the hole meets the torus from the inner radius on.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.05, 0.05, -20> right 16*x up 12*y direction z }
light_source { <3, 5, -20> rgb 1 }
#default { pigment { gradient z scale 0.3 } finish { ambient 0.4 } }
torus { 2, 1 rotate 90*x translate <-4.5, 2.5, 0> }
torus { 2, 1 rotate 90*x translate <-4.5, 2.5, 1> }
torus { 2, 0.5 translate <-4.5, -3, 0> }
torus { 2, 0.5 rotate 90*z translate <-1, -3, 0> }
torus { 2.5, 0.5 rotate 90*x translate <4.5, 2.5, 0> }
torus { 2.5, 0.5 rotate 90*x translate <4.5, 2.5, 0.5> }
torus { 0.5, 1 rotate 90*x translate <2, -3, 0> }
torus { 0.5, 1.5 translate <5.5, -3, 0> }
plane { -z, -4 pigment { checker } }
