// Of faces in the same place the later one shows, but within nested CSG the earlier one (spec 03 5.2).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <3, 3, -6> look_at <0, 0.3, 0> angle 60 }
light_source { <5, 9, -5>, 1 }
#declare Low = box { <-0.5, 0, -0.5>, <0.5, 0.6, 0.5> pigment { rgb <1, 0.3, 0.2> } }
#declare High = box { <-0.5, 0, -0.5>, <0.5, 0.8, 0.5> pigment { rgb <0.3, 0.8, 0.2> } }
#declare Ball = sphere { <0, 0.3, 0>, 0.75 pigment { rgb 1 } }
#declare Both = intersection { object { Low } object { High } }
object { Both translate <-2, 0, -1.2> }
difference { object { Both } sphere { <0.5, 0.6, -0.5>, 0.3 } translate <-0.7, 0, -1.2> }
intersection { intersection { object { Both } object { Ball } } object { Ball } translate <0.6, 0, -1.2> }
intersection { union { object { Low } object { High } } object { Ball } translate <1.9, 0, -1.2> }
merge { union { object { Low } object { High } } cylinder { 0, 1.2*y, 0.1 } translate <-2, 0, 0.5> }
union { object { Both } object { Low translate 2*y } clipped_by { plane { y, 1.5 } } translate <-0.7, 0, 0.5> }
difference {
  box { <-0.5, 0, -0.5>, <0.5, 0.9, 0.5> }
  intersection { box { <0, -1, -1>, <2, 2, 0> pigment { rgb x } } box { <0, 0.4, -2>, <3, 3, 0> pigment { rgb y } } }
  pigment { rgb 1 }
  translate <0.6, 0, 0.5>
}
