#version 3.6;
global_settings {  }
#default { normal { radial 0.8 omega 0.1 omega 0.8  } }
#local Vector1 = <-2, 1.5, 1.5>;
#local Object2 = superellipsoid { <1, 0.5> texture { mandel 10 exponent 3 texture_map { [0.2 pigment { checker pigment { julia <0.3,0.5>, 12 exterior 5, 1 scale (1/2) omega 0.1 transform { rotate <30,0,0> rotate z*180 inverse } }, pigment { checker rgb <0.5,.9,0>, color rgb <0.1,0.25,1> translate <radians(60), 1.0, -2> } translate <-1, 0.1, 0.5> rotate -90*x warp { spherical orientation y } } finish { reflection { 0, 1 fresnel on } }] [0.8 finish { specular albedo 0.15 roughness 0.1 } finish { phong albedo 0.53 conserve_energy diffuse 0 diffuse albedo 1 } pigment { checker pigment { rgb 0 frequency 0 }, pigment { rgbt <1,1,.9,0.25> ramp_wave turbulence 1 translate <0.5, -(0.5), 2> } omega 0.8 lambda 1.5 }] } rotate <30,0,0> lambda 3 } }
#declare Transform3 = transform { rotate -90*x rotate <0,0,90> }
#declare Interior4 = interior { fade_color color red 0.1 fade_distance 0.75 caustics .9 }
camera {  location <3,3,-5> normal { bumps 0.1 } look_at <0,0.5,0> }
light_source { <-10,20,-30>, rgb <1,0.9,0.7> media_attenuation on media_attenuation on }
sky_sphere { pigment { color rgb <0.2,0.4,0.9>  }   }
box { <2.5,0.5,-1>, <1,3.5,-2> normal { spotted (1/2) cubic_wave no_bump_scale } }
object { Object2 finish { conserve_energy } bounded_by { clipped_by } }
object { Object2 finish { diffuse albedo 0.8 specular albedo 0.38 roughness 0.1 } normal { dents 0 rotate z*180 accuracy 0.1 } no_reflection }
prism { conic_sweep 0.5,1, 4 <0,0>, <1,0>, <1,1>, <0,0> sturm inverse }
#debug concat(concat("ab", substr("hello", 1, 2), strupr("q")), "\n")
