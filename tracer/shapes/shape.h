// The one interface of every compiled shape (specs 03 and 04). Immutable, in world space, safe from any thread.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tracer/math/ray_batch.h"
#include "tracer/scene/solid.h"
#include "tracer/shapes/simple_solid.h"

namespace verisim::accel {
class Shaft;
struct EntryPoints;
}  // namespace verisim::accel

namespace verisim::shapes {

class Shape;
struct Clips;

// One crossing of a ray with a surface.
struct Hit {
  double t = 0;
  Vec3 point;                    // POV-Ray's own hit point: O + tD, or the local point mapped back (spec 03 2.1)
  const Shape* shape = nullptr;  // the primitive (never a CSG node) that was hit
  // The shape's own memory between intersect and normal: face, segment, root ... and two parameters.
  std::int32_t part = 0;
  double u = 0, v = 0;
};

// Hits of one query. A thread keeps one and reuses it: no allocation once it has grown.
using HitList = std::vector<Hit>;

// Where in a list the hits of each lane of a packet are.
struct LaneHits {
  explicit LaneHits(HitList& all) : list(all) {}
  HitList& begin_lane(int k) {
    begin[k] = list.size();
    return list;
  }
  void end_lane(int k) { end[k] = list.size(); }

  HitList& list;
  std::size_t begin[RayPacket::kCount] = {}, end[RayPacket::kCount] = {};
};

// Which rays see an object (spec 03 5.5, 06 10.3). Radiosity's, too, are other ones behind a transparent surface and in
// a mirror.
enum class RayKind : unsigned char {
  camera,
  refracted,
  reflected,
  radiosity,
  radiosity_refracted,
  radiosity_reflected,
  shadow,
  photon,
  query
};
// Shadow rays meet nothing nearer than this to the shaded point, to the light and to the previous transparent surface,
// though POV-Ray looks for the boxes of objects as far as the light (spec 06 9.2).
inline constexpr double kShadowTolerance = 1e-3;

// Everything shading needs to know of the object a primitive belongs to; filled by accel::World when it compiles (null
// in bare queries).
struct Surface;

// One of several textures that show at a hit: an index into Shape::extra_textures(), or -1 for the object's own
// texture.
struct TextureShare {
  std::int32_t texture = -1;
  float weight = 1;
};

// Where a shape is solid: outside `box` every point is inside the shape if `outside` is true, and none is if it is
// false.
struct SolidExtent {
  Box3 box;
  bool outside = false;
};

// A box that holds every point.
Box3 everywhere();

class Shape : public scene::Solid {
 public:
  explicit Shape(const scene::Object& description) : object(&description) {}
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;

  // Appends every hit within the shape's own limits (spec 03 2.1 and 2.2), in POV-Ray's order of collection, clips and
  // bounds of this object applied. `kind` lets unions and merges leave out children that this ray does not see.
  virtual void intersect_all(const Ray& ray, RayKind kind, HitList& hits) const = 0;
  // The same, where hits nearer than `from` or farther than `to` may be left out.
  virtual void intersect_between(const Ray& ray, RayKind kind, double /*from*/, double /*to*/, HitList& hits) const {
    intersect_all(ray, kind, hits);
  }
  // The same for several rays; lanes that are not spoken of have none.
  virtual void intersect_packet_between(const RayPacket& rays, RayKind kind, const double* from, const double* to,
                                        LaneHits& hits) const;
  // The nearest hit with t_min <= t < t_max; on equal t the one collected last (spec 03 2.1). The default scans
  // intersect_all.
  virtual bool intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const;
  // The same among the hits inside all of `clips`: what a union that carries clip objects asks its children.
  virtual bool intersect_clipped(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips& clips,
                                 Hit& hit) const;
  // True if any hit has t_min <= t < t_max, for shadow rays.
  virtual bool occludes(const Ray& ray, double t_min, double t_max) const;
  // Shapes with a tree of their own: where the rays of a shaft enter it. False: nothing is gained by asking.
  virtual bool enter(const accel::Shaft& /*shaft*/, accel::EntryPoints& /*entry*/) const { return false; }
  // intersect and occludes for rays of such a shaft.
  virtual bool intersect_from(const accel::EntryPoints& /*entry*/, const Ray& ray, RayKind kind, double t_min,
                              double t_max, Hit& hit) const {
    return intersect(ray, kind, t_min, t_max, hit);
  }
  virtual bool occludes_from(const accel::EntryPoints& /*entry*/, const Ray& ray, double t_min, double t_max) const {
    return occludes(ray, t_min, t_max);
  }
  // intersect and occludes for several rays: of lane k as far as t_max[k], all of which may be read; the lanes that are
  // hit. `entry`: of a shaft that holds them, or null. The defaults ask one ray after another.
  virtual unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                                    const double* t_max, Hit* hits) const;
  virtual unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                                   const double* t_max) const;
  // Formula (inverted where the object is), then clip objects.
  bool inside(const Vec3& p) const override = 0;
  // The same without the object's own clips: cutaway_textures and the camera's containers ask this (spec 03 2.6, 5.3).
  virtual bool inside_unclipped(const Vec3& p) const { return inside(p); }
  // Raw unit normal, negated if the shape carries the "inverted" mark; not turned towards the ray. Only for hit.shape
  // == this.
  virtual Vec3 normal(const Hit& hit) const = 0;
  virtual Vec2 uv(const Hit& hit) const { return {hit.point.x, hit.point.y}; }
  // Conservative world bounds of the surface; infinite shapes return an infinite box.
  virtual Box3 bounds() const = 0;
  // Conservative: see SolidExtent. The default knows nothing.
  virtual SolidExtent solid_extent() const { return {everywhere(), false}; }

  // The numbers of a simple solid, which know nothing of its clips and bounds; of others none. They may be read while
  // the shape lives.
  virtual SimpleSolid simple() const { return {}; }

  // Distances of hits may lead out of bounds(): for some rays; for this ray.
  virtual bool may_stray() const { return false; }
  virtual bool strays(const Ray& /*ray*/) const { return may_stray(); }

  // All rays meet both at the same distances, in the same parts, as they do copies in one place: only the shape of the
  // hits differs, which is the one that was asked.
  virtual bool is_met_like(const Shape& /*other*/) const { return false; }

  // It is part of CSG, or of a union that stays whole: POV-Ray asks for all of its hits, where else height fields and
  // fractals end their search.
  virtual void join_csg() {}

  // Some level of CSG above takes the hits of this primitive in reverse: of equally near ones the first wins (spec
  // 03 5.2).
  virtual void turn_hits() {}
  virtual bool hits_turned() const { return false; }

  // What the rays so far tell the author of the scene about this shape; mostly nothing.
  virtual std::string finding() const { return {}; }

  // The clip objects of this object.
  virtual std::span<const std::unique_ptr<Shape>> clips() const { return {}; }

  // Children of a CSG object, of a light_group or the looks_like of a light; empty for primitives.
  virtual std::span<const std::unique_ptr<Shape>> children() const { return {}; }

  // Textures of components (blob) or triangles (mesh), beside the object's own.
  virtual std::span<const scene::TexturePtr> extra_textures() const { return {}; }
  // Which of them show at a hit; appends nothing: the object's own texture (or interior texture) alone.
  virtual void texture_shares(const Hit& /*hit*/, bool /*inside_hit*/, std::vector<TextureShare>& /*shares*/) const {}

  const scene::Object* object;  // the description; may only be followed while that lives
  const Surface* surface = nullptr;
};

struct CompileOptions {
  bool remove_bounds =
      false;  // drop the bounded_by of this object (not of children) where POV-Ray does so at frame level (spec 03 6.2)
};

// Compiles one object with its children, clips and bounds. Heavy payloads are shared between copies. The description
// must outlive the shape only for those who follow Shape::object.
std::unique_ptr<Shape> compile(const scene::Object& object, const CompileOptions& options = {});

}  // namespace verisim::shapes
