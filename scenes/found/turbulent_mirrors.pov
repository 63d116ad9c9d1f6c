// Mirrors with noise and turbulence in their normals before a backdrop of grains of 1e-12: the last bits of numbers,
// vectors and their octaves show.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> angle 50 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#default { pigment { rgb 0 } finish { reflection 1 } }
#declare Mirror = sphere { 0, 1 }
object { Mirror normal { granite 0.3 } translate <-3, 1.2, 0> }
object { Mirror normal { wood 0.3 turbulence 0.3 scale 0.3 } translate <-1, 1.2, 0> }
object { Mirror normal { marble 0.3 turbulence 0.3 } translate <1, 1.2, 0> }
object { Mirror normal { bozo 0.3 noise_generator 3 scale 0.3 } translate <3, 1.2, 0> }
object { Mirror normal { gradient x 0.3 turbulence 0.3 octaves 4 lambda 2.3 omega 0.6 } translate <-3, -1.2, 0> }
object { Mirror normal { wrinkles 0.5 scale 0.2 } translate <-1, -1.2, 0> }
object { Mirror normal { agate 0.3 } translate <1, -1.2, 0> }
object { Mirror normal { bozo 0.3 noise_generator 1 warp { turbulence 0.3 } scale 0.3 } translate <3, -1.2, 0> }
