#version 3.1;
global_settings { assumed_gamma 2.2 radiosity { count 20 pretrace_start 0.08 pretrace_end 0.04 recursion_limit 1 brightness 0.8 always_sample off } ambient_light rgb <0.5,1,1> }
#declare ColorMap1 = color_map { [0, rgb x] [0.4, rgb <0.8,.9,0.8>] [1, color rgb <.9,0.1,0>] }
#version 1.0
#local Object2 = sor { 5 <0,-1> <0.5,-0.8> <1,0> <0.3,0.8> <0.5,1.2> sturm  };
#declare ColorMap3 = color_map { [0, 0.5 color rgb 1 color rgb x] [0.5, 1 color rgb <0,0,1> color rgb y] };
camera {  location -6*z right x*4/3 }
light_source { <3,4,-6>,rgb 1  }
light_source { -10*z rgb 0.5  }
background { rgb <0,.9,0.8> }
sor { 5 <0,-1> <0.5,-0.8> <1,0> <0.3,0.8> <0.5,1.2> open normal { mandel 10 exterior 0,1 slope_map { [0, <0.25, 1>] [0.4, <0.8, -1>] [1, <.9, -1>] } noise_generator 3 phase -0.3  } no_image }
intersection { box { <1,0,2.5>, <0,1.5,1> bounded_by { plane { y, 0 } plane { x, 0.5 } } } cutaway_textures  }
#debug concat(vstr(3, max_extent(Object2), ",", 0, 3), "\n")
