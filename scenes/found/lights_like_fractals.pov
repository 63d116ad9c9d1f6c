// Fractals that lights look like have one hit a ray, the first, as those outside CSG have: where the light is in CSG,
// too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.6, -3> look_at 0 angle 55 }
light_source { <3, 6, -8> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
#default { finish { ambient 0.3 } }
#declare Fractal = julia_fractal { <-.162, .163, -.56, .1> max_iteration 7 precision 20 slice <.1, .2, -.1, .97>, .05 }
light_source { -0.9*x rgb 0.2 looks_like { Fractal pigment { rgbt <1, 0.5, 0.5, 0.5> } interior { ior 1.2 } } }
intersection {
  union { light_source { 0 rgb 0 looks_like { Fractal } } sphere { <0, 0.8, 0>, 0.3 } }
  plane { -z, 0 }
  plane { y, 0.9 }
  plane { -y, 0.7 }
  rotate 30*y
  translate 0.9*x
  pigment { rgb <0.6, 0.8, 1> }
}
plane { y, -1 pigment { checker rgb 1 rgb 0.5 } }
