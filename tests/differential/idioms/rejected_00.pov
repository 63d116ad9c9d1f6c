camera { location <0 1 -5> direction <0 0 1.5> up <0 1 0> right <1.33 0 0> look_at <0 0 0> }
object { light_source { <10 10 -10> color red 1.0 green 1.0 blue 1.0 } }
object { sphere { <0 0 0> 1 } texture { color red 1 green 0 blue 0 phong 0.9 } }
