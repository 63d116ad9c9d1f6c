// Fresnel's reflectance of glass (n = 1.5) in surroundings of radiance 1: a mirror ball, so that every angle occurs. What is not reflected falls on black.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }
background { rgb 1 }
sphere {
  0, 1.4
  pigment { rgb 0 }
  finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 1 fresnel on } conserve_energy }
  interior { ior 1.5 }
}
