#version 1.0
composite { object { sphere { <0 0 0> 1 } texture { color red 1 } } object { box { <0 0 0> <1 1 1> } } }
