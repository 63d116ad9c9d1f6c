// Five parallel rays, one a pixel at 1x5, from the plane z = 0: what does each meet first?
#version 3.7;
#include "stage.inc"
global_settings { assumed_gamma 1 }
#ifndef (Aside)
  #declare Aside = 0;  // @range 0 1 1
#end

#if (Aside)
  Aside_Camera(<-8, 5, -7>, <0.5, -0.2, 4>)
  // The image plane with its five pixels, and the rays as far as they go.
  #for (I, 0, 4)
    box { <-0.48, 1.52 - I, -0.02>, <0.48, 2.48 - I, 0> pigment { rgb <0.75, 0.82, 0.95> } finish { ambient 0.6 } no_shadow }
    #declare End = array[5] { 7, 3, 1, 1, 9 };
    Arrow(<0, 2 - I, 0>, <0, 2 - I, End[I]>, rgb <0.1, 0.3, 0.7>)
  #end
#else
  camera { orthographic location 0 direction z right x up 5*y }
#end

#macro Object(Low, High, Depth, Color)
  box { <-1, Low, Depth>, <1, High, Depth + 0.5> Flat(Color, Aside) }
#end

// Rays #1 to #5 run at y = 2, 1, 0, -1, -2.
Object( 0.6,  2.4, 7, rgb <1, 1, 0>)  // yellow: #1 and #2
Object(-0.4,  1.4, 3, rgb <1, 0, 0>)  // red: #2 and #3
Object(-1.4,  0.4, 1, rgb <0, 1, 0>)  // green: #3 and #4
Object(-1.4, -0.6, 6, rgb <0, 0, 1>)  // blue: #4
