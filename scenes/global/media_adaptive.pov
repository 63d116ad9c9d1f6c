// Fine adaptive refinement of method 3.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
box { <-1.2,0.05,-1>, <1.2,1.7,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { samples 6 aa_level 6 aa_threshold 0.02 emission 1.5 density { granite scale 1.5 color_map { [0 rgb 0] [0.3 rgb 0.2] [0.5 rgb 1.4] } } } } }
sphere { <0.2,0.6,0.2>, 0.35 pigment { rgb <1,0.5,0.3> } }
