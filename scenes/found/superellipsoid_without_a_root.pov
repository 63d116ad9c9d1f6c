// A cylinder from which a superellipsoid with almost flat faces is cut: along those its field is so steep that twenty
// steps find no root, and the better of the last two points counts (spec 03 4.12).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.2, 0.7, 0.9> direction z right 1.2*x up 0.9*y }
light_source { <20, 7, -2>, 1 }
difference {
  cylinder { <-1, 0.5, 1.5>, <-1.75, 0.5, -3>, 1.45 }
  superellipsoid { <1, 0.1> }
  pigment { rgb <1, 0.9, 0.7> }
  finish { ambient 0 diffuse 1 }
}
