// Lines of text.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare Line = array[4] { "verisimilar", "shapes & text", "Quick Brown Fox", "0123456789" }
#for (I, 0, 3)
  text { ttf "timrom.ttf" Line[I] 0.3, 0 scale 1.1 translate <-3.2, 2.2 - I, 0> rotate -10 * x pigment { rgb <0.8, 0.4 + 0.15 * I, 0.3> } }
#end
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
