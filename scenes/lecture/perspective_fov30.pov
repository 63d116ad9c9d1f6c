// Field of view 30 degrees from top to bottom, aspect 2, near plane at distance 5 along -z. Render at 600x300.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Near = 5;
#declare Y_Max = Near * tan(radians(30 / 2));
#declare X_Max = 2 * Y_Max;
camera { location 0 direction -Near*z right 2*X_Max*x up 2*Y_Max*y }

// The near plane, coloured by position: a small ball marks the point of pixel (150, 150).
plane { z, -Near pigment { checker rgb 0.8, rgb 0.3 scale 0.67 } finish { ambient 0 diffuse 0 emission 1 } }
sphere { <-Y_Max, 0, -Near>, 0.05 pigment { rgb <1, 0, 0> } finish { ambient 0 diffuse 0 emission 1 } }
