#version 3.7;
global_settings { assumed_gamma srgb mm_per_unit 10 max_trace_level 3 }
#local Transform1 = transform { scale <1,2,1> translate <0.1, 0.1, 0.5> }
#declare ColorMap2 = color_map { [0.5 colour rgbf <1,0.8,1,0.99>] }
#declare Pigment3 = pigment { radial pigment_map { [0 triangular color red 1 green 0 blue 0.84, colour rgb <0,.9,.9>, colour rgb <0.25,0,0.38>, color rgb <0.1,0.81,0.1>, rgb <0,1,1>, color rgb z ] [0.5 hexagon pigment { rgb <0.25,.9,0.1>  }, pigment { rgb 1 warp { spherical orientation y } noise_generator 1 lambda 2 }, pigment { colour rgb <0.12,0.25,0.1> triangle_wave } ] [1 slope {y} omega 0] } lambda 1.5 noise_generator 3 turbulence 0 }
camera { ultra_wide_angle location <3,3,-5> sky <0,1,0.2> right -x*1.33 look_at 0 }
fog { distance 5 colour rgb <0.8,0.1,1> fog_type 2 fog_offset 0 fog_alt 0.5 }
prism { linear_sweep linear_spline 0.5,1, 4 <-1,-1> <1,-1> <0,1> <-1,-1> sturm no_shadow inverse }
poly { 2, <1,0,0,0,1,0,0,1,0,-1>  hollow off }
#local K = 0; #while (K < 2) object { polygon { 4 <-1,0,-1> <1,0,-1> <0,0,1> <-1,0,-1> no_shadow } rotate K*90*y } #local K = K + 1; #end
cone { 0, 2, <1,1,0>, 0   }
plane { y, -1 material { texture { normal { pavement number_of_sides 4 number_of_tiles 3 pattern 1 lambda 2 lambda 3 bump_size 1.5 } normal { tiling 22 frequency -1 no_bump_scale } pigment { colour rgb <1,0.12,0> transmit 0.8 noise_generator 3 warp { turbulence <0.5,0,0.5> octaves 3 lambda 2 omega 0.4 } } } interior_texture { pigment { cylindrical pigment_map { [0 rgb <0.55,0.25,0.8> translate -y translate <.75, 0.5, 0.5> frequency 3] [0.4 checker  lambda 1.5] [1 dents color_map { ColorMap2 } noise_generator 1] }  } } scale 1.5 } photons { target reflection on refraction on } material { interior { dispersion 1.05 dispersion_samples 5 media { samples 2, 3 density { agate agate_turb 0.86 colour_map { [0 color rgb <0.25,0.8,1>] [0.3 color <.9,0.5,1>] [0.3 rgb <1,0.5,0>*0.1] [1 rgb 1] }  } aa_level 3 aa_threshold 0.1 } } } }
