// Rings that lie in each other, half a turn apart, in the light of a circular area light: which of two equal surfaces
// hides the other from a sample hangs on the last bits of where the samples are.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 up 3.2*y right 4.8*x }
light_source { <-4, 20, -12>, 0.9 area_light 20*x, 20*y, 3, 3 circular }
#declare Ring = torus { 1, 0.06 scale <2, 1, 1> }
merge {
  object { Ring rotate x }
  object { Ring rotate 61*x }
  object { Ring rotate 181*x }
  object { Ring rotate 301*x }
  pigment { rgb 1 }
  finish { ambient 0 }
}
