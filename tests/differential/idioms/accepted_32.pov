#include "finish.inc"
sphere { 0, 1 pigment { color rgb 1 } finish { Dull } }
sphere { 0, 1 pigment { color rgb 1 } finish { Shiny phong_size 3 } }
