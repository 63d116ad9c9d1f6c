#version 1.0
/* Persistence of Vision Raytracer Version 1.0 */
#include "colors.inc"
#include "textures.inc"
#include "shapes.inc"
camera {
   location <0 20 -100>
   direction <0 0 1.5>
   up <0 1 0>
   right <1.33 0 0>
   look_at <0 0 0>
}
object {
   light_source { <100 100 -50> color White }
}
object {
   union {
      sphere { <0 0 0> 10 }
      quadric { Cylinder_Y scale <4 1 4> }
      intersection { quadric { Cylinder_X scale <1 3 3> } plane { <1 0 0> 20 } plane { <-1 0 0> 20 } }
   }
   bounded_by { box { <-30 -60 -30> <30 60 30> } }
   clipped_by { sphere { <0 0 0> 40 } }
   texture { Red_Marble scale <5 5 5> }
   color Red
}
object {
   plane { <0 1 0> -30 }
   texture { checker color red 1.0 green 1 color Blue scale <10 10 10> }
}
composite {
   object { sphere { <0 0 0> 5 } texture { color Green phong 1 } translate <20 0 0> }
   object { sphere { <0 0 0> 5 } texture { color Blue reflection 0.4 ambient 0.3 } translate <-20 0 0> }
   rotate <0 30 0>
}
