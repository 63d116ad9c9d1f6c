// Before version 3.0 items of pigments, normals and finishes stand in the texture and are taken one by one (spec 05 13).
#version 1.0
camera { location <0 1 -5> direction <0 0 1.5> look_at <0 0 0> }
object { light_source { <10 20 -20> color red 1 green 1 blue 1 } }
#declare Stripes = texture {
  marble
  color_map { [0 0.5 color red 1 color blue 1] [0.5 1.01 color blue 1 color green 1] }
  scale <0.5 0.5 0.5>
  waves 0.3 frequency 3
  turbulence 0.3
  scale <0.7 0.7 0.7>
}
object { sphere { <-1.2 0.6 0> 0.8 } texture { Stripes phong 1 phong_size 20 } }
object { sphere { <1.2 0.6 0> 0.8 } texture { wood color_map { [0 1.01 color red 1 color green 0.5] } ambient 0.3 } }
plane { <0 1 0> -1 texture { gradient <1 0 1> bumps 0.4 scale <0.3 0.3 0.3> reflection 0.2 } }
#version 2.0
#declare Veins = color_map { [0 0.6 color red 1 green 1 color green 0.3] [0.6 1.01 color green 0.3 color red 1] }
sphere { <-1.2, -0.6, -1>, 0.6 texture { marble ripples 0.4 turbulence 0.5 color_map { Veins } scale 0.5 diffuse 0.8 } }
sphere { <0, -0.6, -1>, 0.6 texture { color red 1 ambient 0.2 color_map { Veins } wood phong 1 metallic 0 } }
sphere { <1.2, -0.6, -1>, 0.6 texture { scale 0.3 bozo color_map { Veins } diffuse 0.6 color blue 1 specular 0.5 } }
