// The box of what lies on the inner side of several planes: solids cut out by planes are small though each plane is
// infinite.
#pragma once

#include <optional>
#include <span>

#include "tracer/scene/object.h"

namespace verisim::shapes {

// normal . p <= distance.
struct HalfSpace {
  Vec3 normal;
  double distance;
};

// A conservative box of the points of `known` that lie in all half spaces; sides may be infinite. Empty if nothing lies
// in all of them.
Box3 narrowed(const Box3& known, std::span<const HalfSpace> half_spaces);

// A plane without a matrix and clips: rays may be tested against it in place.
inline std::optional<scene::Plane> plain_plane(const scene::Object& o) {
  const auto* plane = o.as<scene::Plane>();
  if (!plane || o.transform || !o.bounded_by.empty() || !o.clipped_by.empty()) return std::nullopt;
  return *plane;
}

// Where such a plane is solid.
inline std::optional<HalfSpace> half_space_of(const scene::Object& o) {
  const auto plane = plain_plane(o);
  if (!plane) return std::nullopt;
  return o.inverted ? HalfSpace{-plane->normal, -plane->distance - kEpsilon}
                    : HalfSpace{plane->normal, plane->distance + kEpsilon};
}

}  // namespace verisim::shapes
