// A second interior goes on from the first; an interior identifier replaces all of it (spec 08 E).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

plane { z, 3 pigment { checker rgb <1, 0.3, 0.3> rgb <0.3, 0.3, 1> } }
#declare Dense = interior { ior 1.6 }
#declare Ball = sphere { 0, 0.7 pigment { rgbt 1 } interior { ior 1.3 } }
object { Ball interior { fade_distance 0.5 fade_power 2 fade_color rgb <0.9, 0.3, 0.2> } translate -1.5*x }
object { Ball interior { fade_distance 0.5 fade_power 2 } interior { Dense } }
difference {
  object { Ball } box { <-0.2, -0.2, -1>, <0.2, 0.2, 0> }
  pigment { rgbt 1 } interior { ior 1.4 } interior { fade_distance 0.4 fade_power 1 } translate 1.5*x
}
sphere { 1.3*y, 0.5 pigment { rgbt 1 } hollow interior { media { emission 0.3 } } interior { media { emission rgb <0.4, 0, 0> } } }
