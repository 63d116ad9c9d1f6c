light_source { <0,10,0> color rgb 1 area_light <1,0,0>, <0,0,1>, 3, 3 adaptive 1 jitter spotlight point_at 0 tightness 10 radius 10 falloff 20 looks_like { sphere { 0, .1 } } }
sphere { 0, 1 pigment { image_map { png "nofile.png" } } }
