// Spheres of the stones of stones1.inc and stones2.inc on a granite floor.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "stones.inc"
camera { location <0, 4, -9> look_at <0, 0.6, 0> angle 40 }
light_source { <-20, 30, -30> rgb 1 }
plane { y, 0 texture { T_Grnt9 } }
#macro Ball(X, Z, T) sphere { <X, 1, Z>, 1 texture { T } } #end
Ball(-3.3, 0, T_Stone1) Ball(-1.1, 0, T_Stone10) Ball(1.1, 0, T_Stone24) Ball(3.3, 0, T_Grnt12)
Ball(-2.2, 3, T_Stone8) Ball(0, 3, T_Stone18) Ball(2.2, 3, T_Grnt29)
