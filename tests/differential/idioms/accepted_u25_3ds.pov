// exporter: 3DS to POV (3ds2pov/Crossroads) mesh with many smooth triangles
#version 3.0
#include "colors.inc"
global_settings { assumed_gamma 2.2 }
#declare MAT_default = texture { pigment { color rgb<0.7,0.7,0.7> } finish { ambient 0.1 diffuse 0.7 phong 0.3 } }
#declare MAT_GLASS = texture { pigment { color rgbf <0.9,0.9,1.0,0.8> } finish { reflection 0.1 refraction 1 ior 1.2 } }
#declare Object01 = mesh {
  smooth_triangle { <-1.0, 0.0, 0.0>, <0.0, 0.0, -1.0>, <1.0, 0.0, 0.0>, <0.0, 0.1, -1.0>, <0.0, 1.5, 0.2>, <0.1, 0.0, -1.0> texture { MAT_default } }
  triangle { <-1.0, 0.0, 1.0>, <1.0, 0.0, 1.0>, <0.0, 1.5, 1.2> texture { MAT_GLASS } }
  triangle { <-1.0, 0.0, 1.0>, <1.0, 0.0, 1.0>, <1.0, 0.0, 1.0> }
  texture { MAT_default }
}
object { Object01 hollow no_shadow }
#declare Camera01 = camera { location <0, 1, -5> direction <0,0,1.3> up <0,1,0> right <4/3,0,0> look_at <0,.7,0> }
camera { Camera01 }
#declare Light01 = light_source { <10, 20, -30> color rgb <1,1,1> }
object { Light01 }
