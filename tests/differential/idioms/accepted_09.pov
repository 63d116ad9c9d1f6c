#version 3.5;
global_settings { assumed_gamma 1.0 }
sphere { 0, 1 }
