#include "colors.inc"
#declare T1 = texture { pigment { granite color_map { [0.0, 0.4 color Red color Blue] [0.4, 1.0 color Blue color Green] } } }
sphere { 0, 1 texture { T1 } }
sphere { 0, 1 texture { pigment { marble turbulence 1 colour_map { [0.0 0.8 colour rgb 1 colour rgb 0] [0.8 1.001 colour rgb 0 colour rgb 1] } } } }
