// An ultra_wide_angle camera before a backdrop of grains of 3e-15: the last bit of each ray shows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { ultra_wide_angle location <1, 2, -6> angle 113 right 1.7*x up 0.77*y look_at 0 }
box {
  -10, 10
  pigment { function { mod(abs(x + y + z) * 3.3e14, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
