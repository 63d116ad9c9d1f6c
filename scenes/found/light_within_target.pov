// Photons of a light within the bounding sphere of their target: the step follows the true distance (spec 08 J).
#version 3.7;
global_settings { assumed_gamma 1 photons { count 8000 autostop 0 jitter 0 } }
camera { location <0, 8, -14> look_at 0 angle 50 }
background { rgb 0.2 }
light_source { <1, 3, -1>, 1 }
box {
  <-8, -0.1, -8>, <8, 0.1, 8>
  pigment { rgbt <0.8, 0.9, 1, 0.8> } finish { ambient 0 diffuse 1 } interior { ior 1.3 }
  photons { target refraction on reflection on }
}
plane { y, -3 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
