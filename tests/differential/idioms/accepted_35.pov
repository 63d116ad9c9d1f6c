#version unofficial 3.5;
sphere{0,1}
