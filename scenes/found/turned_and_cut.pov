// Lathes in the same place as a cone, as a lathe that was moved, and cut by one: the last bit decides what shows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.3, -7> look_at <0, 0.1, 0> angle 42 }
light_source { <-5, 8, -9> rgb 1 }
plane { y, -1.2 pigment { checker rgb 0.8, rgb 0.5 } }
union {
  lathe { linear_spline 2, <0.8, -1>, <0.3, 1> pigment { rgb <0.9, 0.3, 0.2> } }
  cone { -y, 0.8, y, 0.3 open pigment { rgb <0.2, 0.6, 0.9> } }
  translate -1.9 * x
}
#declare Profile = lathe {
  bezier_spline 8, <0.1, -1.1>, <1.3, -0.9>, <0.9, 0.1>, <0.4, 0.2>, <0.4, 0.2>, <0.2, 0.3>, <0.7, 0.8>, <0.3, 1.1>
}
object { Profile pigment { rgb <0.3, 0.8, 0.4> } }
object { Profile rotate 70 * y pigment { rgb <0.9, 0.8, 0.2> } }
difference {
  lathe { quadratic_spline 6, <0, -1.3>, <0, -1.1>, <0.9, -0.6>, <0.4, 0.2>, <0.7, 0.8>, <0, 1> sturm }
  lathe { cubic_spline 5, <0.3, -1.5>, <0.3, -1.2>, <0.6, -0.3>, <0.2, 0.5>, <0.3, 1> translate -0.35 * z }
  lathe { quadratic_spline 6, <0, -1.3>, <0, -1.1>, <0.9, -0.6>, <0.4, 0.2>, <0.7, 0.8>, <0, 1> sturm translate 0.5 * z }
  pigment { rgb <0.5, 0.5, 0.9> } translate 1.9 * x
}
