// What SDL asks the tracer while it is executed: trace, inside, extents (spec 01 section 11, 03 section 7).
#pragma once

#include <optional>

#include "tracer/scene/object.h"

namespace verisim::query {

struct TraceHit {
  Vec3 point, normal;
};

// A declared object made ready for many queries; compiling is lazy and kept as long as this lives.
class Target {
 public:
  explicit Target(scene::ObjectPtr object);
  ~Target();
  // Nearest hit (t >= 1e-4); direction is normalised here, a zero direction misses. The normal is the geometric one
  // (spec 03 2.5).
  std::optional<TraceHit> trace(const Vec3& origin, const Vec3& direction) const;
  bool inside(const Vec3& p) const;
  // False: a patch or a light source is among its parts; one is enough to deny a CSG object its inside.
  bool has_inside() const { return has_inside_; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  bool has_inside_;
};

}  // namespace verisim::query
