// How far away a fractal is, to the last bit, tells how many random numbers media before it draw: some of these hits
// lie just below a distance of 4, where the march has passed it (spec 04 8).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> right 1.34 * x direction z }
light_source { <3, 4, -6>, 1.2 cylinder point_at <0, 0, 0> radius 1.5 falloff 2 }
media { scattering { 1, 0.03 } method 1 intervals 1 samples 1, 1 }
julia_fractal { <-0.1, 0.6, 0, -0.3> max_iteration 5 pigment { rgb <1, 0.7, 0.4> } }
julia_fractal { <-0.2, 0.6, 0.1, -0.3> max_iteration 5 pigment { rgb <0.4, 0.6, 1> } translate <2.2, 0, 0> }
