// The shares of a blob's textures, in a mirror of 256 that shows their last bits; without a hierarchy parts are added up
// in another order (spec 03 4.13, 08 N).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 1.2, -4.8> look_at <0, 0.2, -9.8> angle 55 }
plane { z, -4.9 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission -128 reflection 256 } no_shadow no_reflection hollow }
#default { finish { ambient 1 diffuse 0 } }
#macro Parts()
  threshold 0.3
  sphere { <-0.5, 0, 0>, 1.5, 1 }
  cylinder { -x, x, 1, 1 pigment { rgb 0.502 } }
  sphere { <0.6, 0.5, 0>, 1.5, 1 pigment { rgb 0.501 } }
  cylinder { -y, x, 1, 1.3 }
  pigment { rgb 0.5005 }
#end
#declare Unordered = blob { Parts() hierarchy off }
blob { Parts() translate <-1.4, 0, 0> }
object { Unordered hierarchy on translate <1.4, 0, 0> }
