// Media inside refracting glass.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "table.inc"
light_source { <3,5,-3> rgb 1 }
sphere { <0,0.9,0>, 0.9 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection 0.1 } interior { ior 1.3 media { emission <0.1,0.3,0.2> absorption 0.3 density { leopard scale 0.1 } } } }
