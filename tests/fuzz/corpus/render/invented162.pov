#version 1.0;
global_settings { assumed_gamma 2.2  }
#declare Material1 = material {  }
#declare Vector2 = <0.572 -1.5,1.0>;
camera {  rotate 10*y location <0,1,-6> look_at 0 }
light_source { <-4,6,-5>,rgb 0.5 fade_distance 10 fade_power 1 parallel point_at 0 }
difference { ovus { 1, 0.5  }
box { <-0.5,-2,0>,<2.5,-1,1.5>  }
lathe { bezier_spline 4 <0.5,-1> <1.5,0> <0.3,0.5> <0.8,1> sturm material {  } }  bounded_by { clipped_by } finish { metallic phong_size 1 phong 0.8 specular albedo .9 roughness 0.1 } pigment { slope y color_map { [0 color green 1 red 0.5] [0.5, rgb 0] [1, color rgb <0.5,0.22,1>] } turbulence 1 } }
isosurface { function { x*x+z*z-0.5+0.1*sin(5*y) } contained_by { box { -1, 1 } } evaluate 1, 1.2, 0.9 bounded_by { plane { y, 0 } plane { x, 0.5 } } }
prism { cubic_spline 0, 1, 7 <-1,-1> <0,-1> <1,0> <0.5,1> <-0.5,0.5> <0,-1> <1,0> hollow inverse material { texture { pigment { hexagon rgb <0.58,0.22,0.1>,rgb <0.25,.9,1>,rgb <0,0.1,0.8> triangle_wave frequency 0.5 scale <1,1e-3,1> } } interior_texture { normal { agate 1.5  no_bump_scale } pigment { rgb <0.25,0.25,0.5> octaves 5 } } } }
difference { box { <-0.5,-2,-1>,<0.5,-0.5,0.5>  }
sphere_sweep { linear_spline 3, <-1,-1,0>, 0.5, -x, 0.3, y, 0.2 normal { pigment_pattern { rgb 0.5 }   } clipped_by { bounded_by } }
union { cone { 0, 0.1, <1,1,0>, 0.2 open  }
bicubic_patch { type 0 flatness 0.01 u_steps 2 v_steps 3 <-1.5,-1.5,0>, <-0.5,-1.5,0.5>, <0.5,-1.5,0.5>, <1.5,-1.5,0>, <-1.5,-0.5,-0.5>, <-0.5,-0.5,0.5>, <0.5,-0.5,0>, <1.5,-0.5,0.5>, <-1.5,0.5,-0.5>, <-0.5,0.5,-0.5>, <0.5,0.5,0.5>, <1.5,0.5,0>, <-1.5,1.5,0>, <-0.5,1.5,0>, <0.5,1.5,0.5>, <1.5,1.5,0> bounded_by { clipped_by } }
prism { cubic_spline 0, 1, 7 <-1,-1> <0,-1> <1,0> <0.5,1> <-0.5,0.5> <0,-1> <1,0> bounded_by { box { <-3,-3,-3>, <3,0.5,3> rotate 20*z } } }  scale 0.01 }  pigment { rgb x+y*0.5  } }
plane { y, -1 rotate z*180 }
