#local Fin = finish { specular .3 } 
#local Obj = object { box { -1, 1 } }
object { Obj finish { Fin } pigment { color rgb <.1 .2 .3> } }
light_source { <10, 20, -30>, 1 }
light_source { <10, 20, -30>, <1,1,1> shadowless }
