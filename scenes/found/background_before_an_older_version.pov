// The transmit of a background that is written from 3.7 on fades it, whatever the version becomes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 }
background { rgb <1, 0.8, 0.1> transmit 0.7 }
plane { y, -1 pigment { rgb 1 } finish { ambient 0.2 reflection 0.5 } }
#version 3.5;
