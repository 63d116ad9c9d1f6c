// A mistake on purpose: array subscript.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -5> look_at 0 }
light_source { <10, 20, -30>, rgb 1 }
#declare A = array[3] { 1, 2, 3 };
sphere { 0, A[3] }
