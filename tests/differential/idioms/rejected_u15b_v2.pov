#version 2.2
// POV-Ray 2.2 style
#include "colors.inc"
#include "shapes.inc"
#include "textures.inc"
#include "stones.inc"
camera { location <0, 5, -14> direction 1.5*z look_at 0 }
light_source { <20,20,-20> color White }
#declare Foo = texture { pigment { granite color_map { [0.0, 0.4 color Red color Blue] [0.4, 1.001 color Blue color White] } turbulence 0.6 } finish { crand 0.01 phong 0.7 phong_size 60 } }
sphere { <0, 0, 0>, 2 texture { Foo } }
intersection { sphere { 0, 2 } plane { x, 0 } plane { -z, 0 inverse } texture { Stone10 } translate x*4 bounded_by { sphere { 0, 2.1 } } }
blob { threshold 0.6 component 1.0 1.0 <0.75, 0, 0> component 1.0, 1.0, <-0.375, 0.64952, 0> texture { pigment { color Yellow } } translate -x*4 sturm }
torus { 1.2, .3 texture { Glass2 } translate <0,3,0> sturm }
fog { color Gray80 distance 80 }
