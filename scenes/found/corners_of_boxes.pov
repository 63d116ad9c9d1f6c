// Rays through edges and corners of boxes: the distance is that of the first face that is clearly farther, whichever
// face is seen. Grains of 1e-12 show its last bits.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-3.01, -1.49, -3> direction <1, 0.5, 1> right 3.2 * x up 2.4 * y }
#default {
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb <0.9, 0.4, 0.1>] [1 rgb <0.2, 0.6, 0.9>] } }
  finish { ambient 1 diffuse 0 }
}
#for (I, -4, 3)
  #for (J, -3, 3)
    box { 0, <0.3, 0.2, 0.3> translate <0.4 * I, 0.3 * J, 0> }
    box { 0, <0.2, 0.1, 0.4> translate <0.4 * I + 0.2, 0.3 * J + 0.2, 0.4> }
  #end
#end
