// Stars, a flower and letters cut out by prisms of all splines.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare Star = prism {
  linear_sweep linear_spline 0, 0.6, 11,
  #for (I, 0, 10) <sin(I * pi / 5), cos(I * pi / 5)> * (mod(I, 2) = 0 ? 1 : 0.45) #end
  rotate -80 * x
}
#declare Flower = prism { cubic_spline 0, 0.5, 23, #for (I, -1, 21) <sin(I * pi / 10), cos(I * pi / 10)> * (mod(I + 2, 2) = 0 ? 1 : 0.6) #end rotate -60 * x }
#declare Drop = prism { bezier_spline 0, 0.5, 8, <0, -1>, <1.6, 0>, <0.5, 1>, <0, 1>, <0, 1>, <-0.5, 1>, <-1.6, 0>, <0, -1> rotate -75 * x }
#declare Tower = prism { conic_sweep linear_spline 0.3, 1, 6, <0, 1>, <0.95, 0.3>, <0.6, -0.8>, <-0.6, -0.8>, <-0.95, 0.3>, <0, 1> rotate 180 * x translate y scale <1, 1.8, 1> }
object { Star translate <-2.6, 0.2, 0> pigment { rgb <0.9, 0.8, 0.3> } }
object { Flower translate <-0.5, 0.3, 0> pigment { rgb <0.9, 0.4, 0.5> } }
object { Drop translate <1.4, 0.2, 0> pigment { rgb <0.3, 0.5, 0.9> } }
object { Tower translate <3, -1, 0> pigment { rgb <0.5, 0.8, 0.5> } }
object { Star scale 1.6 translate <0, 1.4, 3.5> pigment { rgb <0.9, 0.6, 0.3> } }
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
