// Four strips, seen from below and lit through from above, under a sheet that is so near to the second and the fourth
// that it throws a shadow there only where it is remembered. The first strip, seen by refracted rays, has it remembered,
// also for what the camera sees, because nothing else is yet; the third, under another box, has that in its place.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, -10, 0> direction y up 4*z right 4*x }
light_source { <0, 10000, 0>, rgb 1 }
#default { texture { pigment { rgb 1 } finish { ambient 0.05 diffuse 0.9 } } }
#macro Strip(A, B, Height)
  polygon { 5, <A, -2>, <B, -2>, <B, 2>, <A, 2>, <A, -2> rotate 90*x translate Height*y double_illuminate }
#end
#macro Glass(A, B)
  box {
    <A, -4, -3>, <B, -3.5, 3>
    pigment { rgbf 1 }
    finish { ambient 0 diffuse 0 }
    interior { ior 1.5 }
    no_shadow
  }
#end
polygon {
  10, <-20, -20>, <20, -20>, <20, 20>, <-20, 20>, <-20, -20>,
  <0.03, -3>, <0.98, -3>, <0.98, 3>, <0.03, 3>, <0.03, -3>
  rotate 90*x
  translate 0.0005*y
}
Strip(-2, -1.02, -1)
Glass(-2.1, -1.01)
Strip(-0.98, -0.02, 0)
Strip(0.02, 0.98, -1)
Glass(0.01, 0.99)
box { <0.01, -0.5, -2>, <0.99, -0.4, 2> }
Strip(1.02, 2, 0)
