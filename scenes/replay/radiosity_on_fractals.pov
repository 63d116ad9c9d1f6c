// Where a march through a fractal begins hangs on the last bit of the place in the picture, which is no whole number in
// the pretrace (spec 02 1.5); and of gathered rays that are equally long, as on steps of a march, the first tells the
// direction of what is nearest (spec 07 2.6).
#version 3.7;
global_settings { radiosity { count 12 pretrace_start 0.08 pretrace_end 0.04 } }
camera { orthographic location <0, 0, -5> look_at 0 angle 30 }
light_source { <-5, 5, -5>, rgb 1 }
julia_fractal {
  <-0.2, 0.4, 0.3, -0.2> hypercomplex ln max_iteration 4 precision 15 slice <0, 1, 0, 1>, 0
  pigment { rgb <1, 0.5, 0.3> }
  rotate 90*y
}
plane { y, -1 pigment { rgb 0.8 } }
