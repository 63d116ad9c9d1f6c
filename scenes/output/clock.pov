// Looks different for every clock, frame and declared value
#ifndef (Shade) #declare Shade = 0.5; #end
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> right image_width/image_height*x look_at <0, 0.4, 0> angle 50 rotate 20*clock*y }
light_source { <-4, 6, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8, rgb Shade } }
box { -0.4, 0.4 rotate 45*clock*y translate <clock - 0.5, 0.5, 0> pigment { rgb <1, clock_delta, 0.2> } }
#if (clock_on) sphere { <0, 1.2, 0>, 0.2 pigment { rgb <0.2, 0.9, 0.3> } } #end
