#version 3.5
#include "macros_lib.inc"
#include "macros_lib"
#include "colors.inc"
object { Lib_Rail(<-3,0,0>,<3,0,1>,6) pigment { Wheat } }
#debug concat("posts ", str(Lib_Count,0,0), " version ", str(version,0,2), "\n")
light_source { <3,5,-8>, White }
camera { location <0,2,-6> look_at .4*y }
plane { y,0 pigment { checker Gray70 Gray30 } }
