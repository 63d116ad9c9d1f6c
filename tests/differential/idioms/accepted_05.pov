#version 3.1;
sphere { 0, 1 pigment { color rgbf 1 } interior { ior 1.5 caustics 1 media { emission .1 intervals 10 samples 1,10 confidence .9999 variance 1/1000 } } hollow }
