// Photons search for isosurfaces as other rays do, one after another (spec 04 6.3).
#version 3.7;
global_settings { assumed_gamma 1 photons { count 1000 } }
camera { location <0, 1, -4> look_at 0 }
light_source { <5, 5, -5>, 0.8 }
isosurface {
  function { x*x + y*y + z*z - 1 } evaluate 1, 1.2, 0.9 pigment { rgb <1, 0.8, 0> transmit 0.8 }
  photons { target reflection on refraction on } interior { ior 1.3 } finish { reflection 0.3 }
}
plane { y, -1 pigment { rgb 0.8 } }
