// The inside of most hypercomplex fractals is asked with y for z (spec 04 8), so it reaches beyond their boxes: the camera
// is within this one, 6 units before it, and fog is kept out.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.1, -6> look_at 0 angle 40 }
light_source { <-50, 80, -100>, 1 }
fog { distance 5 rgb 0.5 }
merge {
  union {
    julia_fractal { <-0.1, 0.6, 0, -0.3> hypercomplex asinh slice <0, 0, 0, 1>, 0.2 pigment { rgb <1, 0.8, 0.5> } }
    light_group { }
  }
}
