// Mirrors with averages of normals before a backdrop of grains of 1e-12: the last bits of the sum of the weights, which
// has single precision, and of its reciprocal in double precision.
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
#declare Three = normal { average normal_map { [1 bumps 2] [1 onion 1] [1 dents 1] } }
#declare Uneven = normal { average normal_map { [1.3 bumps 2] [0.37 onion 1] [2.1 dents 1] } }
object { Mirror normal { average normal_map { [1 bumps 2 scale 0.3] [1 onion 1] } } translate <-3, 1.2, 0> }
object { Mirror normal { Three } translate <-1, 1.2, 0> }
object { Mirror normal { Three scale 0.4 rotate 20 } translate <1, 1.2, 0> }
object { Mirror normal { average normal_map { [0.1 wrinkles 1] [0.2 bumps 2] } } translate <3, 1.2, 0> }
object { Mirror normal { Uneven } translate <-3, -1.2, 0> }
object { Mirror normal { Uneven scale <0.3, 0.4, 0.5> } translate <-1, -1.2, 0> }
object { Mirror normal { average normal_map { [1 Three] [0.7 Uneven] [1 ripples 0.4] } } translate <1, -1.2, 0> }
object { Mirror normal { gradient x normal_map { [0 Uneven] [1 Three] } } translate <3, -1.2, 0> }
