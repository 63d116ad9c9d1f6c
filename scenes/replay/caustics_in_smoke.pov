// Photons in media: packets that end before their target draw no numbers, those that are still on the way to it sample
// media as eyes do, and gain their emission (spec 07 3.8).
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.15 media 20, 2 } }
camera { location <0, 2, -9> look_at <0, 1.6, 0> angle 40 }
light_source { <-6, 9, -2> rgb 0.5 photons { refraction on reflection on } }
plane { y, 0 pigment { rgb 0.5 } }
box {
  <-4, 0.01, -3>, <4, 4.5, 3> hollow pigment { rgbt 1 }
  interior {
    media { scattering { 1, 0.15 } }
    media { emission <0.02, 0.01, 0> density { spherical scale 3 } }
  }
  photons { pass_through }
}
sphere { <0, 1.8, 0>, 0.8 hollow pigment { rgbt 1 } finish { reflection 0.1 } interior { ior 1.4 } photons { target refraction on reflection on } }
