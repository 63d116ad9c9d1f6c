#version unofficial MegaPov 0.5;
sphere{0,1}
