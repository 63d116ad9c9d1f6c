// Mirrors with maps of normals and slopes before a backdrop of grains of 1e-12: the last bits of what lies between the
// entries show, and those of a normal that goes through a map.
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
object { Mirror normal { gradient x normal_map { [0 bumps 2 scale 0.3] [1 onion 3 scale 0.3] } } translate <-3, 1.2, 0> }
object { Mirror normal { gradient x normal_map { [0.2 bumps 2] [0.6 onion 3] } scale 2 } translate <-1, 1.2, 0> }
object { Mirror normal { checker normal { bumps 2 }, normal { dents 1 } scale 0.5 } translate <1, 1.2, 0> }
object { Mirror normal { gradient y normal_map { [0 wrinkles 1] [0.7 bumps 2] } rotate 30 } translate <3, 1.2, 0> }
object {
  Mirror
  normal { gradient x 0.4 slope_map { [0 <0, 1>] [0.25 <0.3, 0.7>] [0.5 <0.5, 0.25>] } }
  translate <-3, -1.2, 0>
}
object { Mirror normal { wood 0.4 slope_map { [0.1 <0, 1>] [0.37 <0.3, 0.4>] [0.8 <1, -1>] } } translate <-1, -1.2, 0> }
object { Mirror normal { onion 0.6 scale 0.4 slope_map { [0 <0.1, 0.3>] [1 <0.9, 0.7>] } } translate <1, -1.2, 0> }
object { Mirror normal { radial frequency 9 normal_map { [0.1 dents 1] [0.9 ripples 0.4] } } translate <3, -1.2, 0> }
