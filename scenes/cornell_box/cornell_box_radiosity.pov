// The Cornell box with interreflection by radiosity: the walls colour the blocks.
#version 3.7;
#declare Interreflection = "radiosity";
#include "cornell_box.pov"
