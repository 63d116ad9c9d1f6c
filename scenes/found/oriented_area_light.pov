// An area light that turns to what it lights, and a box whose top lies in the plane of a disc that it is merged with:
// whether the top counts as inside of the disc hangs on the last bits of directions to the light's samples.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-2, 3, -8> look_at <-0.35, 0, -0.35> angle 9 }
light_source { <-16, 11, -33>, 0.5 area_light <3, 0.3, 0.2>, <0.1, 3, 0.7>, 2, 2 circular orient }
merge {
  box { <1.5, 1, 0>, <2, 1.25, 1> }
  disc { <0, 1.25, 0>, y, 0.3 }
  rotate <60, 160, 0>
}
plane { y, 0 pigment { rgb 1 } }
