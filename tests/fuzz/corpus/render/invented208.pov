#version 3.7;
global_settings { number_of_waves 4 radiosity { count 20 pretrace_start 0.08 pretrace_end 0.04 recursion_limit 1 gray_threshold 0.3 } }
#macro ObjectMacro1(F1, V2)
prism { cubic_spline 0, 1, 7 <-1,-1> <0,-1> <1,0> <0.5,1> <-0.5,0.5> <0,-1> <1,0> scale 0.5+abs(F1)*0.5 translate V2 }
#end
#declare Pigment2 = pigment { scale 2 colour rgb <.9,0.25,0.25> poly_wave bozo }
#local Material3 = material { texture { pigment { agate color_map { [0, color rgb <0.25,.9,0.5>] [0.3, colour rgb <1,0,0.5>] [0.3, rgb 0.1] [1, rgb <0.25,0,0.8>] } phase 0.25 } } interior_texture { pigment { warp { cylindrical orientation z dist_exp 1 } rgb <0.8,0,0.8> scale 2 } } };
#macro ObjectMacro4(F1, V2)
julia_fractal { <-0.1,0.6,0,-0.3> hypercomplex max_iteration 4 precision 20 scale 0.5+abs(F1)*0.5 translate V2 }
#end
camera {  location -6*z look_at <0,0.5,0> }
light_source { -10*z,rgb 0.5  }
media { emission 0.03 intervals 2 samples 3 method 3 }
object { ObjectMacro4(0.5,vcross(x,y))  }
plane { y, -1 interior { caustics .9 } }
#debug concat(str(pi, 0, 9), "\n")
