// Method 3 of media draws a number for each sample also where jitter is 0; those of method 1 beside it show which
// (spec 07 4.6).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -9> look_at 0 angle 36 }
light_source { <3, 9, -9> rgb 1 }
plane { z, 4 hollow pigment { checker rgb 0.3 rgb 0.6 } }
box { -1, 1 rotate 30 hollow translate -1.5*x pigment { rgbt 1 } interior { media { emission 0.3 absorption 0.2 density { bozo scale 0.5 } } } }
box {
  -1, 1 rotate 20 hollow translate 1.5*x pigment { rgbt 1 }
  interior { media { method 1 intervals 3 samples 2, 2 emission <0.4, 0.3, 0.1> absorption 0.4 density { bozo scale 0.4 } } }
}
