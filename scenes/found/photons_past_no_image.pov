// Photons do not meet what is marked no_image, unless they were reflected: the first ball throws no caustic, and the
// second one does, in light from the mirror only (spec 07).
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.06 autostop 0 jitter 0 } }
camera { orthographic location <0, 5, 0> direction -y right 8*x up 6*z }
light_source { <-6, 4, 0> rgb 1 photons { reflection on refraction on } }
plane { y, -2 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Glass = material {
  texture { pigment { rgbf <1, 0.6, 0.3, 0.9> } finish { ambient 0 diffuse 0 } }
  interior { ior 1.4 }
}
sphere { <-1, 0, 1.4>, 1 material { Glass } no_image photons { target reflection on refraction on collect off } }
sphere { <0, 0, -1.2>, 0.8 material { Glass } no_image photons { target reflection on refraction on collect off } }
box { <2, -1, -2>, <2.1, 1, 0> pigment { rgb 0 } finish { reflection 1 } photons { target reflection on } }
