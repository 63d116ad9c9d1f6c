// An isosurface whose max_gradient is too small, within CSG: POV-Ray searches it for every ray that comes to the
// object, whatever the other parts have met, and remembers the search (spec 04, 6.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-4, 1, -4> rotate 10 * y look_at 0 }
difference {
  blob { threshold 0.3 cylinder { -x, y, 0.4, 1 } }
  isosurface { function { x * x + y * y + z * z - 1 } contained_by { box { -1.1, 1.1 } } }
  pigment { rgb <1, 0.5, 0.5> }
  finish { ambient 1 diffuse 0 }
}
