#version 3.7;
camera { location -5*z look_at 0 }
light_source { <2, 4, -5> rgb 1 area_light x, y, -1e300, 2 }
sphere { 0, 1 pigment { rgb 1 } }
