// From where a ray tree is looked at: without perspective, as in a drawing.
#pragma once

#include <vector>

#include "tracer/math/vec.h"

namespace verisim::cli {

// Unit vectors of the drawing's plane and of what lies behind it, and the part that is seen, in the scene's units.
struct Viewpoint {
  Vec3 center{0, 0, 0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
  double width = 1, height = 1;
  double near = 0;  // along `forward` from the centre: what is nearer than all points is not drawn

  // In pixels of a drawing that is `pixels` wide, y downwards.
  Vec2 project(const Vec3& p, int pixels) const;
};

// Angles in degrees: azimuth 0 looks along +z and 90 along +x, elevation 90 looks down from above. All points are seen,
// with a margin; width by height is the shape of the drawing.
Viewpoint viewpoint_of(const std::vector<Vec3>& points, double azimuth, double elevation, int width, int height);

}  // namespace verisim::cli
