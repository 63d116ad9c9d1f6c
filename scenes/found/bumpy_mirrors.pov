// A bumpy mirror before a backdrop of grains of 1e-12: bumps hang on the last bits of the vector noise.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
plane { y, -1 pigment { rgb 0 } finish { reflection 1 } normal { bumps 0.5 scale 0.7 } }
