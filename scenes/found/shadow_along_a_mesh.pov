// Light that goes along the plane of a triangle passes the edge of the next one, whose box begins there: rounding decides
// whether POV-Ray's search lets it into that box (spec 08 C).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
light_source { <0, 3, 0>, 1 }
mesh {
  smooth_triangle { <-1, -1, 0>, -z, <1, -1, 0>, <1, 0, -1>, <1, 1, 0>, <0, 1, -1> }
  triangle { <-1, -1, 0>, <1, 1, 0>, <-1, 1, 0.5> }
  rotate 45*y
  pigment { rgb <1, 0.8, 0.6> }
}
