camera { ultra_wide_angle location <0,0,-5> look_at 0 angle 100 normal { bumps .1 } }
object { intersection { sphere { 0, 1 } plane { y, 0 inverse } bounded_by { sphere { 0, 2 } } } }
object { difference { box { -1, 1 } sphere { 0, 1.2 } texture { pigment { rgb 1 } } } rotate 45*y }
quadric { <1,1,1>, <0,0,0>, <0,0,0>, -1 }
quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1,0,0,0,-1> sturm }
