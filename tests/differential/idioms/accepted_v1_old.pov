// Version 1.0 style
#version 1.0
#declare Bright = color red 0.9 green 0.8 blue 0.3
camera {
   location <0 1.5 -6>
   direction <0 0 1.3>
   up <0 1 0>
   right <1.33333 0 0>
   look_at <0 0.4 0>
}
object {
   light_source { <3 5 -6> color red 1 green 1 blue 1 }
}
object {
   sphere { <0 0 0> 1 }
   texture {
      color Bright
      phong 0.8
      ambient 0.2
   }
   scale <1 0.6 1>
   translate <0 0.5 0>
}
