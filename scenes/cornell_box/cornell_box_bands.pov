// The Cornell box in its measured spectra, three of twelve wavelength bands a picture: Declare=Bands=0 (400 to 475 nm) to Declare=Bands=3 (625 to 700 nm).
#version 3.7;
#ifndef (Bands) #declare Bands = 0; #end
#declare Interreflection = "none";
#include "bands.inc"
#include "cornell_box.pov"
