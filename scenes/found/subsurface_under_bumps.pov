// A plate with a hole that light scatters in, and bumps on it: they turn highlights and reflections, not what comes from
// below the surface.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 4 subsurface { samples 12, 6 } }
camera { location <0.4, 0.3, -4> look_at 0 angle 38 }
light_source { <-30, 30, -30>, 1 }
difference {
  box { <-1, -1, 0>, <1, 1, 0.2> }
  cylinder { -z, z, 0.3 }
  pigment { rgb <0.8, 0.6, 0.5> }
  normal { bumps 0.6 scale 0.1 }
  finish { diffuse 0.8 specular 0.4 reflection 0.2 subsurface { translucency <0.9, 0.7, 0.5> } }
  interior { ior 1.5 }
}
