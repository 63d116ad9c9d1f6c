// `no_bump_scale` reaches the entries of maps, which all copies of what declares them share: what says nothing of it has
// it, too, if another object of the scene says it (spec 05 10.1). A declared texture of a pattern may take it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 4, -5> look_at <0, 0.2, 0> angle 60 }
light_source { <5, 9, -5>, 1 }
#declare Waves = normal {
  gradient z
  normal_map { [0 bumps 0.6 scale <2, 3, 1>] [1 ripples 0.5 scale <1, 1, 3>] }
  scale <1, 0.3, 1>
}
#declare Parts = texture {
  gradient x
  texture_map {
    [0 pigment { rgb <0.8, 0.6, 0.2> } normal { bumps 0.6 scale <2, 3, 1> }]
    [1 pigment { rgb <0.2, 0.6, 0.8> } normal { ripples 0.5 scale <1, 1, 3> }]
  }
  scale <0.8, 0.3, 1>
}
// What no object of the scene has says nothing.
#declare Dents = normal {
  bozo
  normal_map { [0 dents scale <0.1, 0.4, 0.1>] [1 wrinkles scale <1, 3, 1>] }
  scale <1, 0.4, 1>
}
#declare Unused = sphere { 0, 1 normal { Dents no_bump_scale } }
plane { y, 0 pigment { rgb 0.7 } finish { specular 0.5 } normal { Waves } }
sphere { <-1.5, 0.7, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.3> } normal { Waves no_bump_scale } }
sphere { <0, 0.7, 0>, 0.7 texture { Parts } }
sphere { <1.5, 0.7, 0>, 0.7 texture { Parts no_bump_scale } }
sphere { <0, 0.4, -1.6>, 0.4 pigment { rgb 0.9 } normal { Dents } }
