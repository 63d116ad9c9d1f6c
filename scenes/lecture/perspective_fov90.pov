// Field of view 90 degrees, image plane at z = -1, a wall at z = -3. Render at 80x80.
#version 3.7;
#include "stage.inc"
global_settings { assumed_gamma 1 }
#ifndef (Aside)
  #declare Aside = 0;  // @range 0 1 1
#end

#if (Aside)
  Aside_Camera(<5, 3.5, 4>, <0, 0.5, -1.6>)
  sphere { 0, 0.08 pigment { rgb 0.1 } }
  box { <-1, -1, -1.01>, <1, 1, -1> pigment { rgbt <0.6, 0.75, 1, 0.6> } finish { ambient 0.6 } no_shadow }  // the image plane
  Arrow(<0, 0, 0>, <0, 0.75, -1>, rgb <0.1, 0.3, 0.7>)
  Arrow(<0, 0.75, -1>, <0, 2.25, -3>, rgb <0.1, 0.3, 0.7>)
  box { <-3, -3, -3.02>, <3, 3, -3> pigment { checker rgb 0.9, rgb 0.6 } finish { ambient 0.5 } }
#else
  camera { location 0 direction -z right 2*x up 2*y }
  plane { z, -3 pigment { checker rgb 0.8, rgb 0.3 } finish { ambient 0 diffuse 0 emission 1 } }
#end

sphere { <0, 2.25, -3>, 0.1 Flat(rgb <1, 0, 0>, Aside) }  // where the ray of pixel (40, 10) arrives
