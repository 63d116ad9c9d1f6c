// Outside CSG a superellipsoid reports one hit; where that is nearer than shadows begin, light comes through as if it
// were not there, and not through its far side alone (spec 03 4.12). In an intersection both are known.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, -0.9995, 0> direction -y up 2.4*z right 3.2*x }
light_source { <-12, 35, -11>, 1 }
plane { y, -1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Glass = pigment { rgb <1, 0.9, 0.7> transmit 0.6 }
superellipsoid { <0.25, 0.3> scale <0.7, 1, 0.5> translate <-0.8, 0, 0.6> pigment { Glass } no_image }
union {
  superellipsoid { <0.5, 0.3> scale <0.7, 1, 0.5> translate <0.8, 0, 0.6> }
  sphere { 9*x, 1 }
  pigment { Glass }
  no_image
}
superellipsoid {
  <0.25, 0.5>
  scale <0.7, 1, 0.5>
  translate <-0.8, 0, -0.6>
  clipped_by { box { <-2, -0.9998, -2>, 2 } }
  pigment { Glass }
  no_image
}
intersection {
  superellipsoid { <0.25, 0.3> scale <0.7, 1, 0.5> translate <0.8, 0, -0.6> }
  sphere { 0, 3 }
  pigment { Glass }
  no_image
}
