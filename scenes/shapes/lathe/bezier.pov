// lathe of a bezier spline, and one inside out
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb 0.5 } }
#declare Coat = texture { pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0.1 diffuse 0.8 phong 0.4 } }
object { lathe { bezier_spline 8, <0.2, -1.2>, <1.4, -1>, <1.2, 0>, <0.5, 0.1>, <0.5, 0.1>, <0.1, 0.2>, <1.2, 0.9>, <0.6, 1.2> } texture { Coat } translate -1 * x }
object { lathe { bezier_spline 8, <0.2, -1.2>, <1.4, -1>, <1.2, 0>, <0.5, 0.1>, <0.5, 0.1>, <0.1, 0.2>, <1.2, 0.9>, <0.6, 1.2> sturm } texture { Coat } rotate <70, 0, 30> translate <1.1, 0, 0.5> }
