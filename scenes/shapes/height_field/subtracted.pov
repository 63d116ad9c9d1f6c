// height_field taken out of a box
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
#declare S = height_field {
  function 40, 30 { 0.5 + 0.4 * sin(x * 9) * cos(y * 7) }
  smooth water_level 0.2 translate -0.5 scale <3, 1.2, 3>
}
difference { box { <-1.4, -0.7, -0.2>, <1.4, 1.1, 0.9> } object { S } texture { Coat } rotate <10, 30, 0> }
