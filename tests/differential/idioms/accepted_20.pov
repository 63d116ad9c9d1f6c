camera { location <1.3, -2.4, 2.0> up <0,0,1> sky <0,0,1> right <-1.33,0,0> look_at <0,0,0> angle 30 }
polygon { 5, <0,0,0>, <1,0,0>, <1,1,0>, <0,1,0>, <0,0,0> pigment { color rgb <0.5, 0.5, 0.5> } }
triangle { <0,0,0>, <1,0,0>, <0,1,1> pigment { rgb <1,0,0> } }
