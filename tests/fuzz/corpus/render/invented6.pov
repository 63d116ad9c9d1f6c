#version 3.7;
global_settings { max_trace_level 3 max_trace_level 3 }
#declare Transform1 = transform { transform { rotate <0,45,0> translate <-0.938, 0.743, (1 ? 0.5 : 2)>  } rotate <10,20,30> }
camera { cylinder 1 location <-4,1,-4> look_at 0 }
light_source { <3,4,-6>, rgb 1  }
cone { 0, 2, <1,1,0>, 0.2  clipped_by { plane { x, 0 } } pigment { rgbf <1,.9,1,0.5> poly_wave 2 rotate <0,45,0> octaves 5 } }
intersection { sphere_sweep { linear_spline 3, <-1,-1,0>, 0.5, -x, 0.3, y, 0.2  }
difference { sor { 5 <0,-1> <0.5,-0.8> <1,0> <0.3,0.8> <0.5,1.2> sturm no_reflection }
ovus { 1, 0.5 clipped_by { bounded_by } }
lathe { bezier_spline 4 <0.5,-1> <1.5,0> <0.3,0.5> <0.8,1> sturm clipped_by { bounded_by } }  no_image photons { target reflection on refraction on } }  inverse finish { irid { 0.3 thickness 0.5 turbulence 0.2 } diffuse 0.1 specular albedo 0.36 roughness 0.1 ambient 0 } interior { media { translate <.75, 2, .75> confidence 0.8 variance 1/64 samples 3, 3 scale 1 } } }
union { box { <-1,0,1>, <1,3,1.5> inverse }
superellipsoid { <2, 0.5> pigment { color rgb z phase 0.5 } interior { fade_color rgb x } }  translate <1.974, 0, 0.276> photons { target reflection on refraction on } clipped_by { plane { x, 0 } } }
