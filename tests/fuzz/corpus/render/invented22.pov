#version 3.7;
global_settings { radiosity { count 20 pretrace_start 0.08 pretrace_end 0.04 recursion_limit 1  } adc_bailout 0.05 }
#declare Object1 = cubic { <1,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0> sturm clipped_by { sphere { 0, 1.5 } }  }
#declare Object2 = lathe { bezier_spline 4 <0.5,-1> <1.5,0> <0.3,0.5> <0.8,1> pigment { crackle metric 3 form <-1,1,0> color_map { [0 colour rgb <0.8,0.5,0.1>] [0.3 rgb <0.8,.9,0.5>] [0.3 rgb <0,.9,.9>] [1 color rgb <.9,0,0.25>] } turbulence <0.5,0,0> turbulence <0.5,0,0> } }
camera { perspective location <0,1,-6> look_at <0,0.5,0> }
light_source { <5,5,-5>, color red 1 green 1 blue 1 cylinder point_at <0,0,0> radius 1 falloff 2 looks_like { sphere { 0, 0.3 pigment { rgb <0.5,0.92,1> omega 0.74 warp { cylindrical } frequency 2 } } } }
smooth_triangle { <-1,-1,0>, <0,0,-1>, <1,-1,0>, <1,0,-1>, <0,1,0>, <0,1,-1> pigment { object { plane{y,0} } rgb <1,0.1,0.25>, color rgb <0.5,1,0.25> phase 0.5 translate y omega 0.21 } texture { uv_mapping transform { transform { scale 0.5 translate <3, 0, 1.0>  } translate <0,1>+z  } normal { slope {y} transform { scale 1.5 translate <2, val("0.5"), 1.5>  } warp { spherical orientation y } no_bump_scale } pigment { rgb <0.25,1,.9> poly_wave 2 translate <(1/2), 1.0, -1.546> } } }
object { Object1  }
#switch (2) #case (1) sphere { 0, 5 } #break #range (2,3) merge { ovus { 1, 0.5 texture { uv_mapping pigment { rgb <0,1,0.10> warp { black_hole 0, 1 strength 2 falloff 1 inverse } noise_generator 2 } finish { specular 0.1 reflection { 0.1 0.8 metallic } } } interior_texture { pigment { object { box{0,0.5} } rgb 1, color rgbft <0.22,1,0.5,0.2,0.8> octaves 6 omega .9 warp { repeat 2*z offset <0.5,0,0> } } } material { interior { fade_color rgb 0.25 media { samples 1, 4 intervals 2 } } } }
object { Object1 bounded_by { box { -2, 2 } } hollow on }
torus { 0.75, 0.25  hollow off }   } #break #else #end
