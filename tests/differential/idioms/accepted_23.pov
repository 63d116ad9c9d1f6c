#include "colors.inc"
#include "metals.inc"
#include "glass.inc"
#include "woods.inc"
#include "stones.inc"
#include "golds.inc"
sphere { 0, 1 texture { T_Glass3 } interior { I_Glass } }
box { 0, 1 texture { T_Wood7 } }
box { 0, 1 texture { T_Stone9 } }
torus { 1, .2 texture { T_Gold_3C } }
box { 0,1 texture { T_Brass_3A } }
