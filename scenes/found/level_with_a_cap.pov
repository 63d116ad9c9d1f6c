// Rays along the upper cap of a mirrored cylinder: POV-Ray's boxes around several objects end a little below it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-2, 1.03125, -6> look_at <0, 1.03125, 0> right 10*x up 7.5*y }
sky_sphere { pigment { gradient x color_map { [0 rgb <0.9, 0.5, 0.2>] [1 rgb <0.2, 0.6, 0.9>] } } }
cylinder { <0, 0, 0>, <0, 0.25, 0>, 1.5 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
#declare I = 0;
#while (I < 10)
  sphere { 2*x, 0.015 rotate y*I*36 pigment { rgb 1 } }
  #declare I = I + 1;
#end
