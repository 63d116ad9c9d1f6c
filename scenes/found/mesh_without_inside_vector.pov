// A mesh without inside_vector loses what lies behind the hit that its search found last: in CSG, under the clip of a
// union, and right before the eye (spec 08 C). With `hierarchy off` it keeps everything.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 50 }
light_source { <-40, 60, -90>, 1 }
#macro Sheets(Modifiers_X, Off)
  mesh {
    triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0.3> }
    triangle { <-1, -0.8, 0.5>, <1, -1, 0.9>, <0, 1.2, 0.7> }
    triangle { <-1.2, -1, 1.5>, <1.3, -1, 1.1>, <0, 1.3, 1.7> }
    #if (Off) hierarchy off #end
    translate Modifiers_X*x
  }
#end
difference {
  object { Sheets(-2, no) }
  box { <-4, -2, -2>, <0, -0.5, 0.6> }
  pigment { rgb <1, 0.6, 0.3> }
}
union {
  object { Sheets(0, no) scale <1, 0.7, 1> rotate 10*y }
  sphere { 9, 0.1 }
  clipped_by { plane { -z, -0.5 } }
  pigment { rgb <0.4, 0.8, 0.5> }
}
intersection {
  object { Sheets(2, yes) }
  plane { -y, 0.5 rotate 20*x }
  pigment { rgb <0.4, 0.5, 1> }
}
mesh {
  triangle { <-1, 0.3, 0.00005>, <1, 0.3, 0.00005>, <0, 1, 0.00005> }
  triangle { <-1, 0.3, 0.4>, <1, 0.3, 0.5>, <0, 1, 0.4> }
  pigment { rgb <0.9, 0.9, 0.2> }
  translate <0, 0, -6>
}
