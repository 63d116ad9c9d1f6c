#version 2.0
#declare Red_Tex = texture { pigment { color red 1 } finish { phong 1 ambient 0.2 } }
object { sphere { <0,0,0>,1 } texture { Red_Tex } }
