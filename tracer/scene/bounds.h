// POV-Ray's bounding boxes: binary32 lower corner and edge lengths (spec 03 2.2, 4.11, 5.6).
#pragma once

#include <algorithm>

#include "tracer/scene/object.h"

namespace verisim::scene {

inline constexpr double kBoxLimit = 1e10;        // half extent of an unbounded box
inline constexpr double kCriticalLength = 1e6;   // a CSG or quadric box with a longer side becomes unbounded
inline constexpr float kInfiniteVolume = 2e10f;  // boxes above this are "infinite" for scheduling

Bounds make_bounds(const Vec3& low, const Vec3& high);
Vec3 low_corner(const Bounds& bounds);
Vec3 high_corner(const Bounds& bounds);  // the binary32 sum, as max_extent prints it
Vec3 far_corner(const Bounds& bounds);   // the same in double precision, as boxes of objects of objects take it
float volume(const Bounds& bounds);
// The box of the 8 transformed corners, clamped to +-1e10.
Bounds transformed(const Bounds& bounds, const Transform& t);
Bounds unbounded();

// The box of a shape in its own space, before its matrix. Not for Csg, LightSource and LightGroup.
Bounds local_bounds(const Object& object);
// Of a CSG object or light_group from its children; refits the automatic boxes of quadrics that are direct children of
// an intersection.
Bounds csg_bounds(Object& object);

// A box that is being cut down, in double.
struct BoxRange {
  Vec3 low{-kBoxLimit}, high{kBoxLimit};
  void clip(const Bounds& bounds);
};
// A box that is being widened, in double: the upper corner is a sum of corner and length in double precision.
struct BoxUnion {
  Vec3 low{kBoxLimit}, high{-kBoxLimit};
  void extend(const Bounds& bounds) {
    for (int i = 0; i < 3; ++i) {
      const double corner = bounds.low[i];
      low[i] = std::min(low[i], corner);
      high[i] = std::max(high[i], corner + static_cast<double>(bounds.size[i]));
    }
  }
  Bounds bounds() const { return make_bounds(low, high); }
};
// Narrows a range by an axis-parallel plane (with POV-Ray's error for scaled matrices).
void clip_by_plane(const Object& plane, BoxRange& range);
// POV-Ray says "Unnecessary bounding object removed." of this one at frame level (spec 03 6.2).
bool bounds_are_removed(const Object& object);

// The automatic box of a quadric within `range` and its own clips, if smaller than the present one (spec 03 4.11).
void fit_quadric(Object& object, BoxRange range);

}  // namespace verisim::scene
