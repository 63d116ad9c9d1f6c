// A solid colour that takes the place of a map that lets light through: what it covers is dark, but it is not remembered
// as what blocked the light last, for the map is there still.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 8, -6> look_at 0 }
plane { y, 0 pigment { checker rgb 1 rgb 0.3 } }
light_source { <2, 5, -24>, 1 }
#declare Ball = sphere {
  <-1, 0, -1>, 2
  pigment { bozo pigment_map { [0 rgbt 1] [0.5 rgbt 0.6] [1 rgbt <0.8, 0.8, 0.9, 0.2>] } scale 0.4 }
}
sphere { <-1, 0, -1>, 2 pigment { rgb 1 } }
object { Ball }
object { Ball rotate 200 * y pigment { rgb z } }
