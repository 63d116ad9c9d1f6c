#version 3.6;
global_settings { assumed_gamma 2.2  }
#default { texture { uv_mapping pigment { srgb <0.5,0.6,0.7> lambda 1.5 scale <2,.5,1> } } }
#local Finish1 = finish { emission color rgb 0.4 specular 0.25 };
#local Transform2 = transform { matrix <0,1,0,1,0,0,0,0,1,0,0,0> transform { rotate 90*y scale <2,.5,1>  } };
camera {  location <0,2,-7> rotate 10*y direction 1.5*z look_at 0 }
light_source { <0,10,0> rgb 0.5 area_light x, z, 2, 3  }
quadric { <1,0,1>, <0,0,0>, <0,0,0>, -1  no_shadow }
difference { union { smooth_triangle { <-1,-1,0>, <0,0,-1>, <1,-1,0>, <1,0,-1>, <0,1,0>, <0,1,-1> texture { pigment { rgb <0.25,0.38,0.5> octaves 2 } rotate 90*y normal { tiling 8 slope_map { [0 <0.25, 0>] [0.3, <0.1, 1>] [0.3 <1, -1>] [1, <0.5, -1>] } translate <1.0,1, val("0.5")> octaves 4 bump_size 1 } } interior_texture { pigment { warp { cylindrical } spiral1 2 pigment_map { [0 wood color_map { [0, 0.5 color rgb 1 color rgb x] [0.5, 1 color rgb <0,0,1> color rgb y] } ] [0.5, rgb <1,1,1> turbulence 0 transform Transform2] [0.5, warp { black_hole <0.5,0,0>, 0.7 } triangular  lambda 3 phase 0.5 frequency 2] [0.9, triangular pigment { color rgb <1,0,0> filter 0.1 omega 0.5 frequency 2 },pigment { rgb <1,0,0> filter 0  },pigment { rgb <0.8,0.1,0.8> lambda 3 omega 0.8 },pigment { warp { black_hole 0, 1 strength 2 falloff 1 inverse } colour rgb <0.8,0.1,0.25> transform { scale 2 scale 0.5 inverse } },pigment { colour rgb <1,0.5,0>*1 turbulence 1 scale <1,1e-3,1> phase 0.5 } frequency -1 poly_wave noise_generator 1] } frequency 3 } } }
sphere { <0, 1 0>, sqrt(2)  }
isosurface { function { x*x+y*y+z*z-1 } contained_by { box { -1.1, 1.1 } } threshold 0.1 clipped_by { plane { y, 0.25 } } scale 0.591 rotate <0,45,0> }  pigment { cells colour_map { [0, rgb <1,0.1,0> transmit 1] [1 rgb <.9,0.5,0.1>] }  } }  no_image }
