#include "colors.inc"
#declare RED_FIN = finish { ambient .25 diffuse .65 }
#declare Layer_0 = texture { pigment { color red 0.7 green 0.2 blue 0.2 } finish { RED_FIN } };
#declare Layer_1 = texture { pigment { color Cyan } finish { RED_FIN } }
#declare obj01 = mesh {
  triangle { <0,0,0>, <10,0,0>, <5,8,3> }
  triangle { <10,0,0>, <5,0,8>, <5,8,3> texture { Layer_1 } }
  triangle { <5,0,8>, <0,0,0>, <5,8,3> }
  smooth_triangle { <0,0,0>,<0,-1,0>, <10,0,0>,<.1,-1,0>, <5,0,8>,<0,-1,.1> }
  texture { Layer_0 }
}
#declare bbox_lo = min_extent(obj01); #declare bbox_hi = max_extent(obj01);
object { obj01 bounded_by { box { bbox_lo - .001, bbox_hi + .001 } } translate -(bbox_lo + bbox_hi)/2 }
object { obj01 scale <.5, .5, .5> rotate <90, 0, 0> translate <8, 0, 3> texture { pigment { Yellow } } }
camera { location <4, 6, -22> look_at <2,0,0> up y right 4/3*x }
light_source { <20, 30, -20> color White }
