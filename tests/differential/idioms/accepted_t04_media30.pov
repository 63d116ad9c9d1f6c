#version 3.1;
camera { location <0,1,-5> look_at 0 }
light_source { <4,6,-6> color rgb 1 }
sphere { 0, 1.2 pigment { rgbf 1 } hollow
  interior { media { emission .4 intervals 4 samples 1, 5 confidence .9 variance 1/100 density { spherical turbulence .3 color_map { [0 rgb 0] [.5 rgb <1,.4,0>] [1 rgb <1,1,.3>] } } } }
}
plane { y,-1.3 pigment { checker color rgb .9 color rgb .3 } hollow on }
