// Where light leaves glass of dispersion, the wavelengths that are totally reflected stay white: they are split anew
// where they leave at last (spec 06 6.5). The camera is in the glass. Later reflections keep the wavelength.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, -1, 0> direction <0, 0.66, 0.75> right 0.9*x up 0.7*y }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <1, 0.9, 0.8>] [1 rgb <0, 0.1, 0.3>] } }
  pigment { gradient x color_map { [0 rgbt 1] [0.5 rgb <1, 0.5, 0>] [1 rgbt 1] } scale 0.3 }
}
intersection {
  plane { y, 0 }
  plane { -y, 3 }
  plane { <0.3, 0, 1>, 2 }
  plane { <-0.4, 0.1, -1>, 2 }
  plane { x, 2 }
  plane { -x, 2 }
  pigment { rgbf 1 }
  finish { ambient 0 diffuse 0 reflection 0.05 }
  interior { ior 1.5 dispersion 1.2 dispersion_samples 5 }
}
