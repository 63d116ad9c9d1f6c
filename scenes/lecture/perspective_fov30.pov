// Field of view 30 degrees from top to bottom, aspect 2, near plane at distance 5 along -z. Render at 600x300.
#version 3.7;
#include "stage.inc"
global_settings { assumed_gamma 1 }
#ifndef (Aside)
  #declare Aside = 0;  // @range 0 1 1
#end
#declare Near = 5;
#declare Y_Max = Near * tan(radians(30 / 2));
#declare X_Max = 2 * Y_Max;

#if (Aside)
  Aside_Camera(<9, 5, 3>, <0, 0, -3>)
  // The eye, the pyramid of what it sees, and the ray of the pixel (150, 150).
  sphere { 0, 0.15 pigment { rgb 0.1 } }
  #for (I, -1, 1, 2)
    #for (J, -1, 1, 2) cylinder { 0, <I * X_Max, J * Y_Max, -Near>, 0.015 pigment { rgb 0.3 } no_shadow } #end
  #end
  Arrow(<0, 0, 0>, <-Y_Max, 0, -Near>, rgb <0.1, 0.3, 0.7>)
  box { <-X_Max, -Y_Max, -Near - 0.02>, <X_Max, Y_Max, -Near> pigment { checker rgb 0.9, rgb 0.6 scale 0.67 } finish { ambient 0.5 } }
#else
  camera { location 0 direction -Near*z right 2*X_Max*x up 2*Y_Max*y }
  // The near plane, coloured by position.
  plane { z, -Near pigment { checker rgb 0.8, rgb 0.3 scale 0.67 } finish { ambient 0 diffuse 0 emission 1 } }
#end

// A small ball marks the point of pixel (150, 150).
sphere { <-Y_Max, 0, -Near>, 0.05 + 0.05 * Aside Flat(rgb <1, 0, 0>, Aside) }
