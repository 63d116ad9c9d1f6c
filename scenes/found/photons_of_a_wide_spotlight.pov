// Photons keep within the falloff of a spotlight, light reaches to its radius, which is 30 where it is not written.
#version 3.7;
global_settings {
  assumed_gamma 1
  photons { spacing 0.04 }
}
camera {
  location <0, 3, -5>
  look_at 0
}
light_source {
  <-5, 5, 0>, rgb 0.7
  spotlight
  falloff 5
  point_at 0
  photons { refraction on reflection on }
}
sphere {
  <0, 1, 0>, 1
  pigment { rgbf 1 }
  interior { ior 1.5 }
  photons { target refraction on reflection on }
}
plane {
  y, -0.5
  pigment { rgb 1 }
}
