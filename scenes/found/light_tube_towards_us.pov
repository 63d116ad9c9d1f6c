// Media show the tubes of cylindrical lights; where the line of sight comes towards the light and leaves its tube behind
// it they are dark.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -1> look_at <0, 0.35, 0> }
plane { y, 0 pigment { rgb 0.8 } }
plane { -z, -1 pigment { rgb 0.5 } }
light_source { <1, 2, -1>, rgb 0.3 }
light_source { <0.1, 0.6, 0.5>, rgb <5, 0, 0> cylinder radius 0.03 falloff 0.07 point_at <-0.05, 0.35, -1> }
light_source { <-0.5, 0.4, 0>, rgb <0, 3, 8> cylinder parallel radius 0.05 falloff 0.1 point_at <0.3, 0, -0.1> }
light_source { <0.3, 0.4, 0>, rgb <3, 3, 0> cylinder radius 0.05 falloff 0.06 point_at <0.4, 0.4, 1> }
media { scattering { 2, rgb 0.5 extinction 0 } }
