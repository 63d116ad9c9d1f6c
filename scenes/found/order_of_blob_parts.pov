// Equal parts of a blob are added up from the last to the first, however often the spheres around them are divided (spec
// 08 N): the first part alone stays beside two that cancel out, the others are lost in their rounding.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <2, 0, -9> look_at <2, 0, 0> right 16*x up 12*y }
light_source { <-50, 80, -100>, 1 }

#macro Parts(First, Third, Last, Apart)
  blob {
    threshold 0.2
    sphere { 0, 1.5, First }
    sphere { <Apart, 0, 0>, 1.25, 1 }
    sphere { 0, 1.5, 1e-9 }
    sphere { 0, 1.5, Third }
    sphere { 0, 1.5, 1e-9 }
    sphere { 0, 1.5, Last }
    sphere { <Apart, 0, 0>, 1.25, 1 }
    pigment { rgb <1, 0.8, 0.6> }
  }
#end
union { Parts(1, 1e20, -1e20, 4) translate <-2, 4, 0> }
union { Parts(1e20, 1, -1e20, 4) translate <-2, 0, 0> }
union { Parts(-1e20, 1e20, 1, 4) translate <-2, -4, 0> }

// Capsules of equal axes, of which one is a hole that the others nearly fill.
blob {
  threshold 0.3
  cylinder { -x, x, 0.5, -0.5 }
  cylinder { -x, x, 1, 1 }
  cylinder { -x, x, 1, -0.5 }
  scale 2 translate <6, 0, 0>
  pigment { rgb <0.6, 0.8, 1> }
}
