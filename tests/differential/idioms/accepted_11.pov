// café naïve Latin-1 ©
#version 3.7;
global_settings{assumed_gamma 1}
#declare S="café"
sphere{0,1}
