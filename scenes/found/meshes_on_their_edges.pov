// Of two triangles of a mesh that a ray meets in one place the order of their boxes tells which is seen, not that of the
// file (spec 08 C).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6 * z right 4 / 3 * x }
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb x } }
#macro Crossing(Far)
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> texture { Red } }
  triangle { <0, -1, 0>, <1, 0, 0>, <0, 1, Far> }
#end
mesh { Crossing(1) scale <2, 2, 1> pigment { rgb y } translate -y }
mesh { Crossing(1) scale <-2, 2, 1> pigment { rgb z } translate y }
mesh { Crossing(-1) inside_vector <0.1, 0.2, 1> pigment { rgb x + y } translate <-2, -1, 0> }
