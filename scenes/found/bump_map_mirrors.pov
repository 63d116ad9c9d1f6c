// Mirrors with a bump map and with dents before a backdrop of grains of 1e-12: heights have the luma's last bit.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#declare Mirror = texture { pigment { rgb 0 } finish { reflection 1 } }
plane {
  y, -1 texture { Mirror }
  normal { bump_map { function 32, 32 { pigment { gradient x triangle_wave color_map { [0 rgb <0, 0.3, 0.1>] [1 rgb <0.9, 0.4, 0.7>] } } } interpolate 2 bump_size 3 } }
}
sphere { <-1.2, 0.4, 0>, 0.9 texture { Mirror } normal { dents 0.5 scale 0.4 } }
sphere {
  <1.2, 0.4, 0>, 0.9 texture { Mirror }
  normal { bump_map { function 32, 32 { pigment { bozo scale 0.2 color_map { [0 rgb <0, 0.3, 0.1>] [1 rgb <0.9, 0.4, 0.7>] } } } map_type 1 bump_size 2 } }
}
