// A mistake on purpose: include missing quote.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -5> look_at 0 }
light_source { <10, 20, -30>, rgb 1 }
#include "colors.inc
#include "textures.inc"
sphere { 0, 1 }
