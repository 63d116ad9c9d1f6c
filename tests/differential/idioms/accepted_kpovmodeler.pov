// In the manner of KPovModeler: everything on lines of its own, comments with names, #declare in capital letters
#include "colors.inc"
#declare OBJ1 = union {
  superellipsoid {
    <0.25, 0.25>
    scale <1, 0.5, 1>
  }
  lathe {
    cubic_spline
    5,
    <0.1, -1>,
    <0.3, -0.5>,
    <0.7, 0.1>,
    <0.2, 0.8>,
    <0.1, 1.2>
    sturm
    rotate <0, 0, 15>
  }
}
camera {
  perspective
  location <0, 2.5, -5.5>
  sky <0, 1, 0>
  direction <0, 0, 1>
  right <1.33333, 0, 0>
  up <0, 1, 0>
  look_at <0, 0.5, 0>
}
light_source {
  <4, 5, -5>, rgb <1, 1, 1>
  area_light <1, 0, 0>, <0, 1, 0>, 3, 3
  adaptive 0
  circular
  orient
  fade_distance 10
  fade_power 1
}
sky_sphere { pigment { gradient <0, 1, 0> color_map { [0 rgb <0.2, 0.3, 0.6>] [1 rgb <0.8, 0.9, 1>] } } }
object {
  OBJ1
  texture {
    pigment { marble turbulence 0.6 octaves 4 omega 0.5 lambda 2 color_map { [ 0.0 color rgbft <0.8, 0.7, 0.6, 0, 0> ] [ 0.5 Orange ] [ 1.0 color rgb <0.3, 0.1, 0> ] } scale <0.4, 0.4, 0.4> }
    normal { granite 0.2 scale <0.3, 0.3, 0.3> }
    finish { ambient rgb <0.1, 0.1, 0.1> diffuse 0.6 brilliance 1 phong 0.2 specular 0.3 roughness 0.02 metallic 0.5 }
  }
  rotate <0, 30, 0>
  translate <0, 0.7, 0>
  no_reflection
}
prism {
  linear_sweep
  bezier_spline
  0, 0.3,
  8,
  <-0.5, 0>, <-0.5, 0.6>, <0.5, 0.6>, <0.5, 0>,
  <0.5, 0>, <0.5, -0.6>, <-0.5, -0.6>, <-0.5, 0>
  sturm
  pigment { color Green }
  translate <2, 0, 0>
}
sor { 6, <0.2, -0.4>, <0.4, 0.0>, <0.6, 0.2>, <0.3, 0.7>, <0.35, 1.0>, <0.5, 1.3> open pigment { rgb <.3,.4,.9> } translate <-2, 0.2, 0> }
plane {
  <0, 1, 0>, -0.5
  pigment { hexagon rgb <1,1,1>, rgb <.5,.5,.5>, rgb <.8,.3,.2> }
  finish { reflection rgb <0.1, 0.1, 0.1> }
}
