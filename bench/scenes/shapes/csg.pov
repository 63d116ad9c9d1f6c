// Dice, a cheese, a lens and a bearing: differences, intersections and merges.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
#declare Die = difference {
  intersection { box { -1, 1 } sphere { 0, 1.4 } }
  sphere { <0, 0, -1>, 0.25 }
  sphere { <0.5, 1, 0.5>, 0.25 } sphere { <-0.5, 1, -0.5>, 0.25 }
  sphere { <1, 0.5, 0.5>, 0.25 } sphere { <1, -0.5, -0.5>, 0.25 } sphere { <1, 0, 0>, 0.25 }
  sphere { <-1, 0.5, 0.5>, 0.25 } sphere { <-1, 0.5, -0.5>, 0.25 } sphere { <-1, -0.5, 0.5>, 0.25 } sphere { <-1, -0.5, -0.5>, 0.25 }
  scale 0.75
}
object { Die rotate <-10, 25, 0> translate <-2.6, 0.1, 0> pigment { rgb <0.8, 0.5, 0.4> } }
object { Die rotate <-10, -40, 0> translate <2.4, 0.1, -1> pigment { rgb <0.8, 0.8, 0.4> } }
difference { cylinder { -0.7 * y, 0.7 * y, 1.2 } plane { x, 0 rotate 30 * y } cylinder { -y, y, 0.4 } sphere { <0.8, 0.6, -0.6>, 0.4 } sphere { <0.2, 0.6, -1>, 0.3 } rotate 60 * y translate <-0.2, 0, 0.6> pigment { rgb <0.9, 0.8, 0.3> } }
intersection { sphere { -0.8 * z, 1.2 } sphere { 0.8 * z, 1.2 } rotate 50 * y translate <1, 1.7, 1> pigment { rgb <0.4, 0.7, 0.9> } }
merge { torus { 0.8, 0.25 } cylinder { -x, x, 0.2 } cylinder { -z, z, 0.2 } rotate -60 * x translate <2.8, 1, 2> pigment { rgb <0.4, 0.5, 0.9> } }
plane { y, -1 pigment { rgb <0.5, 0.6, 0.5> } }
