// The Cornell box by direct light only: what no wall throws on stays black.
#version 3.7;
#declare Interreflection = "none";
#include "cornell_box.pov"
