// The box of a julia_fractal is made after its modifiers: bounds in its own statement do not cut it down, those of a
// copy do (spec 03 2.2), for what is remembered of shadows, too (spec 08 D).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 angle 50 }
light_source { <5, 8, -6>, 1 }
#declare Fractal = julia_fractal { <-0.1, 0.6, 0, -0.3> max_iteration 5 precision 20 pigment { rgb <0.9, 0.6, 0.2> } }
julia_fractal {
  <-0.1, 0.6, 0, -0.3> max_iteration 5 precision 20 pigment { rgb <0.2, 0.6, 0.9> }
  bounded_by { box { -0.4, 0.4 } } translate -1.5 * x
}
object { Fractal bounded_by { box { -0.4, 0.4 } } translate 1.5 * x }
plane { y, -1.6 pigment { checker rgb 0.8 rgb 0.6 } }
