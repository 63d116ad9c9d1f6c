// A light that is projected through something: air acts as far as the light (spec 06 9.4).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> }
media { absorption <0.06, 0.08, 0.1> }
plane { y, -1 pigment { rgb 1 } }
sphere { 0.2*y, 0.8 pigment { rgbt <1, 0.5, 0.2, 0.4> } }
light_source {
  <-2, 6, -3> rgb <0, 1, 2> media_attenuation on shadowless projected_through { disc { <-1, 3, 0>, y, 2 } }
}
light_source { <1, 5, -3> rgb 3 media_attenuation on projected_through { disc { 3*y, y, 1.5 } } }
