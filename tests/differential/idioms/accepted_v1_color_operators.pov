#version 1.0
// Before 1.5 numbers have no operators without parentheses, but colors have.
#declare Dim = color red 1 green 0.5
#declare Dimmer = rgb 1*.5
camera { location <0, 0, -5> look_at <0, 0, 0> }
light_source { <5, 5, -9> color rgb <1, 1, 1>*0.7 }
background { rgb <0, 0, 1>*.5 }
sphere { <0, 0, 0>, 1
  pigment { gradient x color_map { [0 rgb <1, 1, 0>*.5] [1 color Dim*0.8] } }
  finish { ambient .5*.3 }
}
sphere { <2, 0, 0>, 0.5 pigment { Dim*0.5 + 0.2 } }
