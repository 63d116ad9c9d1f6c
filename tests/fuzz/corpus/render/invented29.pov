#version 3.7;
global_settings { assumed_gamma 1  }
#declare Float1 = 1.5;
#declare Object2 = intersection { cone { -y, pi/4, 2*y, 0.2 open clipped_by { plane { y, 0 } plane { x, 0.5 } } hollow off }
blob { threshold 0.3 sphere { <0, -1, 0.5>, 1.5, 2 pigment { color rgb <1,0.5,0> transmit 0.25 omega 0 warp { planar } turbulence 0.3 } rotate 90*y } sphere { <-1, -1, -0.5>, 1.5, 2   } sphere { <0, 1, -0.5>, 1, 2   } double_illuminate texture { uv_mapping checker texture { pigment { rgb <0.1,0.1,0.25> triangle_wave frequency 0 lambda 2 } }, texture { pigment { dents pigment_map { [0 leopard pigment_map { [0 rgb <0.1,0.8,0.1> phase 0.5 scale 0.25 noise_generator 3] [0.5 rgb <0.25,0.25,.9> turbulence 0.3 omega 0.25 lambda 2] [1 rgb <0.25,0.25,0.25> scallop_wave] } rotate <30,0,0> translate 1] [1 checker pigment { color red 0.8 warp { spherical orientation y } turbulence 0 scale 1.5 }, pigment { color green 1 red 0.5 noise_generator 2 sine_wave } lambda 1.5 scallop_wave] } phase 0.5 } } lambda 1.5 } }
ovus { 1, 0.5 finish { phong 0.8 diffuse 0.5, .9 } pigment { cubic rgb x+y*0.5, colour rgb <0.8,1,0.1>, rgb <1,1,1>, colour rgb 0.8, rgb <1,0.5,0.25>, color rgb 0 noise_generator 1 } } cutaway_textures no_shadow texture { uv_mapping pigment { brick pigment { color rgbt <1,1,.9,1>  }, pigment { brick  mortar 0.1 omega 0 } mortar 0.1  } } bounded_by { clipped_by } }
#declare Float3 = min(1,2);
camera {  location <0,0,-5> angle 60 up y look_at 0 }
light_source { -10*z, rgb 1  }
union { sor { 5 <0,-1> <0.5,-0.8> <1,0> <0.3,0.8> <0.5,1.2> open  } }
plane { y, -1  }
#debug concat(str(vlength(<1.5, int(1.7), 3> + <0,0,0>), 0, 5), "\n")
