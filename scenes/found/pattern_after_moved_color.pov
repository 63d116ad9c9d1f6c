// A pattern that takes the place of a solid colour has gone the way that the object went meanwhile (spec 08 E).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

plane { y, -1 pigment { rgb 1 } translate <0.2, 0.1, 0.13> pigment { checker rgb 0.2 rgb 1 scale 0.7 } }
sphere { <-1.4, 0, 0>, 0.6 finish { ambient 0.3 } rotate 40*z pigment { checker rgb x rgb 1 scale 0.3 } }
union { sphere { 0, 0.5 } box { 0, 0.6 } pigment { rgb 1 } rotate 30*y scale 1.1 pigment { gradient x color_map { [0 rgb z] [1 rgb 1] } scale 0.2 } }
#declare Ball = sphere { 0, 0.6 pigment { rgb 1 } rotate 30*z };
object { Ball translate 1.4*x pigment { brick rgb 1 rgb x scale 0.05 } }
blob { threshold 0.5 sphere { 0, 1, 1 pigment { rgb 1 } rotate 25*z pigment { checker rgb y rgb 1 scale 0.2 } } translate 1.2*y }
