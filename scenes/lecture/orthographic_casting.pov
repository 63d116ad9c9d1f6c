// Five parallel rays, one a pixel at 1x5, from the plane z = 0: what does each meet first?
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 0 direction z right x up 5*y }

#macro Object(Low, High, Depth, Color)
  box { <-1, Low, Depth>, <1, High, Depth + 0.5> pigment { color Color } finish { ambient 0 diffuse 0 emission 1 } }
#end

// Rays #1 to #5 run at y = 2, 1, 0, -1, -2.
Object( 0.6,  2.4, 7, rgb <1, 1, 0>)  // yellow: #1 and #2
Object(-0.4,  1.4, 3, rgb <1, 0, 0>)  // red: #2 and #3
Object(-1.4,  0.4, 1, rgb <0, 1, 0>)  // green: #3 and #4
Object(-1.4, -0.6, 6, rgb <0, 0, 1>)  // blue: #4
