// Mirrors with ripples and waves before a backdrop of grains of 1e-12: the last bits of sines, sources and sums.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#declare Mirror = texture { pigment { rgb 0 } finish { reflection 1 } }
plane { y, -1 texture { Mirror } normal { ripples 0.3 frequency 3 phase 0.2 scale 0.7 } }
sphere { <-1.2, 0.4, 0>, 0.9 texture { Mirror } normal { waves 0.3 frequency 2 phase 0.1 scale 0.4 } }
sphere { <1.2, 0.4, 0>, 0.9 texture { Mirror } normal { gradient x 0.3 sine_wave scale 0.3 } }
