// Whether transmit fades a background is decided where it is written: by the version there, not by the last one.
#version 3.5;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 }
background { rgb <1, 0.8, 0.1> transmit 0.7 }
plane { y, -1 pigment { rgb 1 } finish { ambient 0.2 reflection 0.5 } }
#version 3.7;
