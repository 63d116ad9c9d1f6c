// Where a point of a sor lies on the axis, rounding may take the extreme that its cubic has there below it. Its radius is
// no number then, and no ray finds the segment, or all goes well, as here the second time.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -5> look_at <0, 0.7, 0> angle 50 }
light_source { <5, 10, -8>, 1 }
plane { y, -0.5 pigment { checker rgb 1 rgb 0.4 } }
#default { pigment { rgb <0.9, 0.7, 0.4> } finish { phong 0.5 } }
sor { 6, <0, 0>, <1, 0>, <1, 1>, <0, 1.2>, <0, 2>, <0, 2> rotate <30, 300, 0> translate -1.3 * x }
sor { 7, <0.4, -0.4>, <0.9, 0.1>, <0.8, 0.7>, <0, 1.1>, <0.5, 1.7>, <0.3, 2>, <0.2, 2.3> rotate 20 * z translate 1.3 * x }
