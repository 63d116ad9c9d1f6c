// The Cornell box with a sphere of glass and a mirror in the place of the blocks.
#version 3.7;
#declare Spheres = true;
#declare Max_Trace_Level = 12;
#include "cornell_box.pov"
