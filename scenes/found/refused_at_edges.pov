// Some rays that run through the edge of a box are refused by the boxes of POV-Ray's hierarchy, in single precision: its
// own, or one around several objects.
#version 3.0;
global_settings { assumed_gamma 1 }
camera { orthographic location <6, 3, -6> look_at <0, 1, 0> right 8*x up 6*y }
light_source { <-10, 40, -25> rgb 1 }
background { rgb <0.1, 0.2, 0.7> }
box { <-5, -0.5, -5>, <5, 0, 5> pigment { rgb <0.9, 0.8, 0.3> } }
box { <-4, 1.75, -3>, <-0.75, 2.5, -1> pigment { rgb <0.3, 0.8, 0.4> } }
