// A mistake on purpose: elif.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -5> look_at 0 }
light_source { <10, 20, -30>, rgb 1 }
#declare A = 2;
#if (A = 2)
  #elif (A = 3)
#end
sphere { 0, 1 }
