// Mirror beads in a ring, each lit from below by a lamp of its own: where photons lie in their map, and so which of them
// a search overlooks, hangs on the last bits of the directions in which they start (spec 07 3.5).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 photons { spacing 0.008 gather 2, 6 } }
camera { location <0, 2.4, -3.2> look_at <0, 0.1, 0.3> angle 60 }
plane { y, 0 pigment { rgb <0.4, 0.3, 0.2> } }
#for (I, 0, 11)
  #local Turn = 0.3 + I * pi / 6;
  light_source {
    <0.7 * cos(Turn), 0.45, 0.7 * sin(Turn)> rgb <0.3, 0.6, 0.7>
    photons { reflection on refraction on }
  }
  sphere {
    <0.6 * cos(Turn), 0.6, 0.6 * sin(Turn)>, 0.05
    pigment { rgb 0.7 } finish { diffuse 0.3 reflection 1 }
    photons { target reflection on }
  }
#end
