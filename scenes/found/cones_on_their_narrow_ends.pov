// The narrow ends of cones lie in the planes that they stand on: which of both shows hangs on the last bit of the
// height of the end in the cone's own frame, a quotient of lengths, not of radii (spec 03 4.3).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, -4, -7> look_at <0, 0.4, 0> angle 40 }
light_source { <5, -10, -9>, 1 shadowless }
plane { y, 0 pigment { checker rgb <0.2, 0.5, 1> rgb <0.9, 0.9, 0.3> scale 0.2 } }
#declare Red = texture { pigment { rgb <1, 0.2, 0.1> filter 0.5 } finish { ambient 0.3 } }
#declare I = 0;
#while (I < 5)
  cone { <I - 2, 0, -0.6>, 0.28 + 0.03*I, <I - 2, -1.3, -0.6>, 0.4 + 0.07*I texture { Red } hollow }
  cone { <I - 2, 0, 0.7>, 0.17 + 0.06*I, <I - 2, 0.9, 0.7>, 0.5 texture { Red } hollow }
  #declare I = I + 1;
#end
