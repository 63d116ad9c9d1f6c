// Which isosurfaces a ray searches, and in which order, is told by POV-Ray's hierarchy, and each of these searches is
// remembered (spec 04 6.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> }
light_source { <0, 10, 0>, 0.5 }
isosurface { function { x*x + z*z - 0.5 + 0.1 * sin(5*y) } pigment { rgb <0.4, 0.8, 0.3> } finish { ambient 0.5 } }
isosurface {
  function { x*x + z*z - 0.5 + 0.1 * sin(5*y) } pigment { rgb <0.9, 0.4, 0.2> } finish { ambient 0.5 }
  clipped_by { plane { y, 0.25 } }
}
