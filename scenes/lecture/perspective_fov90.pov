// Field of view 90 degrees, image plane at z = -1, a wall at z = -3. Render at 80x80.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 direction -z right 2*x up 2*y }

plane { z, -3 pigment { checker rgb 0.8, rgb 0.3 } finish { ambient 0 diffuse 0 emission 1 } }
sphere { <0, 2.25, -3>, 0.1 pigment { rgb <1, 0, 0> } finish { ambient 0 diffuse 0 emission 1 } }  // where the ray of pixel (40, 10) arrives
