// What a solid colour of a blob went through is forgotten as its statement ends: the gradients of the copies begin at
// the origin of the second row's moves, not of the first (spec 08 E). Only blobs forget.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 8*x up 6*y }
#default { finish { ambient 1 diffuse 0 } }
#declare Rows = pigment { gradient y color_map { [0 rgb 0] [1 rgb <1, 0.8, 0.3>] } }
#declare Move = transform { rotate 40*z translate <0.2, 0.3, 0> }
#declare Soft = blob { sphere { 0, 1.3, 1 } threshold 0.4 pigment { rgb 1 turbulence 0.3 transform { Move } } }
#declare Hard = sphere { 0, 0.8 pigment { rgb 1 turbulence 0.3 transform { Move } } }
#declare Turned = blob { sphere { 0, 1.3, 1 } threshold 0.4 finish { ambient 0.9 } transform { Move } }
#declare Later = object { Soft rotate 20*z }
object { Soft pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } translate <-2.5, 1.5, 0> }
object { Hard pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } translate <0, 1.5, 0> }
object { Turned pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } translate <2.5, 1.5, 0> }
object { Later pigment { gradient y color_map { [0 rgb 0] [1 rgb <0, 1, 0>] } } translate <-2.5, -1.5, 0> }
object { Soft rotate 50*z pigment { gradient y color_map { [0 rgb 0] [1 rgb <0, 1, 1>] } } translate <0, -1.5, 0> }
object { Soft texture { Rows } translate <2.5, -1.5, 0> }
