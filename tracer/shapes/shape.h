// The one interface of every compiled shape (specs 03 and 04). Immutable, in world space, safe from any thread.
#pragma once

#include <memory>
#include <vector>

#include "tracer/math/vec.h"
#include "tracer/scene/object.h"

namespace verisim::shapes {

class Shape;

// One crossing of a ray with a surface.
struct Hit {
  double t = 0;
  Vec3 point;                   // POV-Ray's own hit point: O + tD, or the local point mapped back (spec 03 2.1)
  const Shape* shape = nullptr; // the primitive (never a CSG node) that was hit
  // The shape's own memory between intersect and normal: face, segment, root ... and two parameters.
  std::int32_t part = 0;
  double u = 0, v = 0;
};

// Hits of one query. A thread keeps one and reuses it: no allocation once it has grown.
using HitList = std::vector<Hit>;

// Which rays see an object (spec 03 5.5, 06 10.3).
enum class RayKind : unsigned char { camera, refracted, reflected, radiosity, shadow, photon, query };

// Everything shading needs to know of the object a primitive belongs to; filled by accel::World when it compiles (null in bare queries).
struct Surface;

class Shape {
 public:
  virtual ~Shape() = default;

  // Appends every hit within the shape's own limits (spec 03 2.1 and 2.2), in POV-Ray's order of collection, clips and bounds of this object applied.
  // `kind` lets unions and merges leave out children that this ray does not see.
  virtual void intersect_all(const Ray& ray, RayKind kind, HitList& hits) const = 0;
  // The nearest hit with t_min <= t < t_max; on equal t the one collected last (spec 03 2.1). The default scans intersect_all.
  virtual bool intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const;
  // Formula (inverted where the object is), then clip objects.
  virtual bool inside(const Vec3& p) const = 0;
  // Raw unit normal, negated if the shape carries the "inverted" mark; not turned towards the ray. Only for hit.shape == this.
  virtual Vec3 normal(const Hit& hit) const = 0;
  virtual Vec2 uv(const Hit& hit) const { return {hit.point.x, hit.point.y}; }
  // Conservative world bounds; infinite shapes return an infinite box.
  virtual Box3 bounds() const = 0;

  const Surface* surface = nullptr;
};

using ShapePtr = std::unique_ptr<const Shape>;

// Compiles one object with its children, clips and bounds. Heavy payloads are shared between copies.
std::unique_ptr<Shape> compile(const scene::Object& object);

}  // namespace verisim::shapes
