// The last digits of letters, straight and curved walls and both ends, in mirrors before a backdrop whose grains are 1e-11
// wide: outlines in font units divided by those of an em, each letter's place in its matrix.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.4, -4> look_at <0, 0.4, 0> }
box { -9, 9 hollow pigment { function { mod(abs(x + y + z) * 1e11, 1) > 0.5 } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
text { ttf "timrom.ttf" "Roboc" 0.4, 0 scale <1, 1.3, 1> rotate <15, 35, 0> translate <-1.2, 0.1, -0.3> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
