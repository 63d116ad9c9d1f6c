// A fractal that is taken away bounds what is left, and a transformation puts its inside back (spec 08 M).
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.3, 0.5, 0.9> }
camera { location <0, 3.5, -9> look_at 0 angle 40 }
light_source { <-2, 6, -9>, 1 }
#declare Fractal = julia_fractal { <-0.3, 0.2, 0.1, 0> pigment { rgb <1, 0.3, 0.2> } }
#declare Block = box { <-2, -1, -1>, <1, 1, 0.5> pigment { rgb <1, 0.8, 0.4> } }
difference { object { Block translate -1.6*x } object { Fractal translate -1.6*x } }
difference { object { Block } object { Fractal } translate 2*x }
