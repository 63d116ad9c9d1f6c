#version 3.6;
global_settings { assumed_gamma srgb max_trace_level 1 ambient_light rgb <0.5,1,1> }
#declare Finish1 = finish { roughness 0.01 reflection { color rgb 0.2, color rgb 0.6 metallic 0.5 } diffuse albedo .9 phong 0.8 }
#declare Texture2 = texture { average texture_map { [0.5 pigment { warp { black_hole <0.5,0,0>, 0.7 } triangular   }] } }
#local Interior3 = interior {  };
camera { perspective location <0,5,0.01> look_at <0,0.5,0> }
light_source { <5,5,-5>,rgb <1,0.9,0.7> media_attenuation on }
fog { distance 5 rgb <0.5,0,.9> turbulence 0.3 turb_depth 0.2 }
torus { 1, 0.5 sturm no_reflection pigment { rgb <0.1,0.15,1> rotate <0,45,0> } clipped_by { box { <-3,-3,-3>, <3,0.5,3> rotate 20*z } } clipped_by { plane { y, 0.25 } } }
box { <-2,-1,-1>,<-1,1,1> inverse normal { aoi 1 scale 1.5  } no_image }
