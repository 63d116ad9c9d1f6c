#version 3.0
#declare Clear_Glass = texture {
  pigment { color rgbf <0.98, 1, 0.99, 0.8> }
  finish { ambient 0 diffuse 0.1 reflection 0.1 refraction 1 ior 1.45 specular 0.8 roughness 0.003 phong 1 phong_size 400 caustics 0.5 fade_distance 3 fade_power 2 }
}
#declare Count = 0
#while (Count < 6)
  #declare Ang = Count*60
  sphere { <2,0.5,0>, 0.5 texture { #if (mod(Count,2) = 0) Clear_Glass #else pigment { rgb <1,.3,.2> } #end } rotate Ang*y }
  #declare Count = Count + 1
#end
plane { y, 0 pigment { brick color rgb 0.9, color rgb <.6,.2,.1> brick_size <1,.5,.5> mortar 0.05 } }
light_source { <5,9,-8> color rgb 1.2 }
camera { location <0,3,-6> look_at 0.3*y }
global_settings { max_trace_level 8 }
sky_sphere {
  pigment {
    gradient y
    color_map { [0.0 0.6 color rgb <0.7,0.8,1> color rgb <.2,.3,.8>] [0.6 1.0 color rgb <.2,.3,.8> color rgb <0,0,.3>] }
  }
}
#if (version < 3.1) #debug concat("version ", str(version,0,2), "\n") #end
