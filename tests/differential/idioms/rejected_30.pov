#version 3.5;
#include "transforms.inc"
#include "math.inc"
#include "functions.inc"
isosurface { function { f_noise3d(x,y,z) - y } contained_by { box { -1, 1 } } max_gradient 3 }
object { sphere { 0, 1 } Axis_Rotate_Trans(y, 30) }
#declare v = vnormalize(<1,2,3>);
