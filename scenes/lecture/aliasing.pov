// A chequered floor up to the horizon: far away its squares are smaller than pixels.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Square = 0.6;  // @range 0.1 3
camera { location <0, 1, 0> look_at <0, 0.75, 1> right 4/3*x angle 60 }
plane { y, 0 pigment { checker rgb 0.95, rgb 0.05 scale Square } finish { ambient 0 diffuse 0 emission 1 } }
sphere { <0.9, 0.5, 3.2>, 0.5 pigment { rgb <0.9, 0.3, 0.1> } finish { ambient 0 diffuse 0 emission 1 } }
background { rgb <0.6, 0.75, 0.95> }
