// A backdrop whose grains are 1e-11 wide shows the last digits of directions: refracted between two glasses (a ratio in
// single precision) and between glass and nothing (in double), dispersed, and mirrored by a normal in a frame.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 }
plane { -z, -9 pigment { function { mod(abs(x + y + z) * 1e11, 1) > 0.5 } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
#declare Clear = pigment { rgbt <0.9, 1, 1, 0.9> }
sphere { -1.6*x, 1.2 pigment { Clear } interior { ior 1.45 } }
sphere { <-1.4, 0.2, -0.3>, 0.6 pigment { Clear } interior { ior 1.7 } }
sphere { <1.3, 0.7, 0>, 0.9 pigment { Clear } interior { ior 1.3 dispersion 1.05 dispersion_samples 3 } }
sphere { <1, -1.2, 2>, 1.2 pigment { rgb 0 } normal { gradient x 0 scale <1, 2, 1> rotate 20*z } finish { reflection 0.9 } }
