// A camera with an angle whose half is a last bit off if it is multiplied by pi before it is divided, before a backdrop
// of grains of 1e-14: the last bit of each ray shows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -6> angle 12.345 look_at 0 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e14, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
