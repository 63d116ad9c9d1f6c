#version 2.0
#include "colors.inc"
#declare Wave_Tex = texture {
  pigment { color red 0.3 green 0.5 blue 0.9 }
  normal { waves 0.4 frequency 5.0 phase 0.3 }
  finish { reflection 0.25 ambient 0.2 phong 0.6 phong_size 30 }
}
#declare Pillar = union {
   difference {
     box { <-0.5 0 -0.5> <0.5 2 0.5> }
     cylinder { <0 -0.1 0> <0 2.1 0> 0.3 }
   }
   quartic { < 1.0 0 0 0 2.0 0 0 2.0 0 -2.18 0 0 0 0 0 0 0 0 0 0 1.0 0 0 2.0 0 1.82 0 0 0 0 1.0 0 -2.18 0 0.8281 > sturm scale 0.6 rotate 90*x translate 2.2*y }
}
camera { location <0 2 -7> direction <0 0 1.5> up <0 1 0> right <4/3 0 0> look_at <0 1 0> }
object { light_source { <5 8 -7> colour White } }
object { Pillar texture { pigment { wood turbulence 0.05 colour_map { [0.0 0.5 colour red 0.6 green 0.4 blue 0.2 colour red 0.5 green 0.3 blue 0.1] [0.5 1.01 colour red 0.5 green 0.3 blue 0.1 colour red 0.7 green 0.5 blue 0.3] } scale 0.2 rotate <88 3 0> } } rotate 30*y }
plane { y 0 texture { Wave_Tex } }
quadric { <1 0.5 1> <0 0 0> <0 0 0> -0.5 translate <2.3 0.8 0> pigment { colour Orange quick_colour Red } }
triangle { <-3 0 0> <-2 0 0> <-2.5 1.4 0.5> pigment { gradient y color_map { [0 color Blue] [1 color Yellow] } scale 1.4 } }
smooth_triangle { <-3.6 0 -1> <-.3 .3 -1> <-2.6 0 -1> <.3 .3 -1> <-3.1 1 -1> <0 .8 -1> pigment { colour Green } }
blob { threshold 0.6 component 1.0 1.0 <-1.8 0.5 -1.5> component 1.0 0.8 <-1.2 0.5 -1.5> component -0.4 0.6 <-1.5 1 -1.9> pigment { colour Magenta } }
fog { colour red 0.6 green 0.7 blue 0.8 distance 60 }
