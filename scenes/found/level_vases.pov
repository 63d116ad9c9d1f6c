// Vases whose rings lie level with the eye, and one with a segment so thin that its cubic has lost its digits: what the
// closed form of POV-Ray makes of them (spec 08 F). Nothing but the hits that the eye sees counts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 55, -150> look_at <0, 45, 0> angle 40 }
light_source { <100, 200, -200>, 1 }
plane { y, -1 pigment { checker rgb 0.7 rgb 0.5 scale 20 } }
sor {
  7, <14, -5>, <14, 0>, <15.5, 25>, <16.5, 45>, <19, 55>, <21, 70>, <21.3, 80>
  pigment { gradient y scale 3 }
  finish { ambient 1 diffuse 0 }
  translate -25*x
}
sor {
  6, <12, -10>, <12, 0>, <12, 50.001>, <11, 50.002>, <6, 62>, <4, 75>
  pigment { checker rgb <0.4, 0.6, 0.7> rgb 1 scale 4 }
  finish { ambient 1 diffuse 0 }
  translate 25*x
}
