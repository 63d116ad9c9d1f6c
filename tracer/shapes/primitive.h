// The base class of every primitive: inverted mark, clips, bounds and matrix are handled here, so that a shape is one
// small file.
//
// A shape `class Torus final : public Primitive<Torus>` writes
//   template <class Sink> void intersections(const Ray& ray, Sink& sink) const;  // calls sink.add for every hit
//   bool contains(const Vec3& p) const;                                          // its inside, not inverted
//   Vec3 geometric_normal(const Hit& hit) const;                                 // unit length, not inverted
// where hits are those within the shape's own limits,
// and passes its own box to the constructor. `intersections` is a template, so "all hits" and "the nearest hit" are
// compiled from the same code; where all hits are expensive it may ask `Sink::kNearest` and stop after an accepted hit
// when it finds hits in increasing distance.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>

#include "tracer/shapes/tree_on_demand.h"
#include "tracer/shapes/scratch_hits.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {

// clipped_by and bounded_by of one object.
struct Guards {
  std::vector<std::unique_ptr<Shape>> clips, bounds;

  // Null when the object has neither.
  static std::unique_ptr<const Guards> of(const scene::Object& object);
  // p is inside every clip object.
  bool contain(const Vec3& p) const {
    for (const auto& clip : clips)
      if (!clip->inside(p)) return false;
    return true;
  }
  // The ray meets every bounding object in front, or starts inside it (spec 03 2.1).
  bool admit(const Ray& ray) const;
  // The lanes that are admitted.
  unsigned admit(const RayPacket& rays) const;
  // The lanes of a packet that hit the shape that these guard, if that is a simple solid. Null `hits`: any hit will do.
  // Nothing: one ray is to be asked after another.
  std::optional<unsigned> meet(const Shape& shape, const RayPacket& rays, RayKind kind, double t_min,
                               const double* t_max, Hit* hits) const;

 private:
  TreeOnDemand tree_;
  mutable std::atomic<std::uint8_t> asked_{0};  // how often for packets, up to where a tree pays
};

inline std::span<const std::unique_ptr<Shape>> clips_of(const Guards* guards) {
  return guards ? std::span<const std::unique_ptr<Shape>>(guards->clips) : std::span<const std::unique_ptr<Shape>>();
}

// The clip objects of the unions that a shape is part of, innermost first.
struct Clips {
  const Guards& guards;
  const Clips* outer = nullptr;

  bool contain(const Vec3& p) const {
    for (const Clips* c = this; c; c = c->outer)
      if (!c->guards.contain(p)) return false;
    return true;
  }
};

// Collects every hit.
class AllHits {
 public:
  static constexpr bool kNearest = false;
  // Those beyond from .. to may be left out.
  AllHits(const Shape& shape, const Guards* guards, HitList& hits,
          double from = -std::numeric_limits<double>::infinity(), double to = std::numeric_limits<double>::infinity())
      : shape_(shape), guards_(guards), hits_(hits), from_(from), to_(to) {}

  // `point` is a callable that yields the hit point; it is only called when needed. True: the hit was accepted.
  template <class PointAt>
  bool add(double t, PointAt&& point, std::int32_t part = 0, double u = 0, double v = 0) {
    const Vec3 p = point();
    if (guards_ && !guards_->contain(p)) return false;
    hits_.push_back({t, p, &shape_, part, u, v});
    return true;
  }
  static constexpr bool any() { return false; }
  // The point is cut away by clipped_by; `add` would refuse it.
  bool clipped(const Vec3& p) const { return guards_ && !guards_->contain(p); }
  double lower() const { return from_; }
  double upper() const { return to_; }

 private:
  const Shape& shape_;
  const Guards* guards_;
  HitList& hits_;
  const double from_, to_;
};

// Keeps the nearest hit in [t_min, t_max); of hits at equal t the last one. `any`: the first one found will do, further
// ones are not looked for.
class NearestHit {
 public:
  static constexpr bool kNearest = true;
  NearestHit(const Shape& shape, const Guards* guards, double t_min, double t_max, Hit& hit, bool any = false,
             const Clips* clips = nullptr)
      : shape_(shape),
        guards_(guards),
        clips_(clips),
        t_min_(t_min),
        t_limit_(t_max),
        t_max_(t_max),
        hit_(hit),
        any_(any) {}

  template <class PointAt>
  bool add(double t, PointAt&& point, std::int32_t part = 0, double u = 0, double v = 0) {
    if (!(t >= t_min_) || !(found_ ? t <= t_max_ : t < t_max_)) return false;
    const Vec3 p = point();
    if (clipped(p)) return false;
    hit_ = {t, p, &shape_, part, u, v};
    t_max_ = any_ ? -std::numeric_limits<double>::infinity() : t;
    found_ = true;
    return true;
  }
  bool clipped(const Vec3& p) const { return (guards_ && !guards_->contain(p)) || (clips_ && !clips_->contain(p)); }
  bool clipped_from_outside() const { return clips_ != nullptr; }
  bool found() const { return found_; }
  bool any() const { return any_; }
  // Forgets the hit that was found.
  void restart() {
    t_max_ = t_limit_;
    found_ = false;
  }
  // Hits outside lower() .. upper() (world distances) need not be reported.
  double lower() const { return t_min_; }
  double upper() const { return t_max_; }

 private:
  const Shape& shape_;
  const Guards* guards_;
  const Clips* clips_;
  const double t_min_, t_limit_;
  double t_max_;
  Hit& hit_;
  const bool any_;
  bool found_ = false;
};

// A ray in a shape's own space, direction of unit length; world distance = local distance / scale.
struct LocalRay {
  Vec3 origin, direction;
  double scale = 1;
};

// What a shape says about its own box and solid.
struct LocalBox {
  Box3 box;                  // in the shape's own space, before its matrix; everywhere(): infinite
  bool solid_inside = true;  // `contains` is false outside the box
  bool clips_narrow = true;  // what is clipped away is not where hits seem to be, either
};

template <class Derived>
class Primitive : public Shape {
 public:
  void intersect_all(const Ray& ray, RayKind, HitList& hits) const final {
    if (guards_ && !guards_->admit(ray)) return;
    all_of(ray, AllHits(*this, guards_.get(), hits), hits);
  }
  void intersect_between(const Ray& ray, RayKind, double from, double to, HitList& hits) const final {
    if (guards_ && !guards_->admit(ray)) return;
    all_of(ray, AllHits(*this, guards_.get(), hits, from, to), hits);
  }
  bool intersect(const Ray& ray, RayKind, double t_min, double t_max, Hit& hit) const final {
    if (guards_ && !guards_->admit(ray)) return false;
    NearestHit sink(*this, guards_.get(), t_min, t_max, hit);
    derived().intersections(ray, sink);
    return sink.found();
  }
  bool intersect_clipped(const Ray& ray, RayKind, double t_min, double t_max, const Clips& clips,
                         Hit& hit) const final {
    if (guards_ && !guards_->admit(ray)) return false;
    NearestHit sink(*this, guards_.get(), t_min, t_max, hit, false, &clips);
    derived().intersections(ray, sink);
    return sink.found();
  }
  bool occludes(const Ray& ray, double t_min, double t_max) const final {
    if (guards_ && !guards_->admit(ray)) return false;
    Hit hit;
    NearestHit sink(*this, guards_.get(), t_min, t_max, hit, true);
    derived().intersections(ray, sink);
    return sink.found();
  }
  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (guards_)
      if (const auto lanes = guards_->meet(*this, rays, kind, t_min, t_max, hits)) return *lanes;
    return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (guards_)
      if (const auto lanes = guards_->meet(*this, rays, RayKind::shadow, t_min, t_max, nullptr)) return *lanes;
    return Shape::occludes_packet(rays, entry, t_min, t_max);
  }
  bool inside(const Vec3& p) const final { return (!guards_ || guards_->contain(p)) && derived().formula(p); }
  bool inside_unclipped(const Vec3& p) const final { return derived().formula(p); }
  void turn_hits() override { turned_ = true; }
  bool hits_turned() const final { return turned_; }
  Vec3 normal(const Hit& hit) const final {
    const Vec3 n = derived().geometric_normal(hit);
    return inverted_ ? -n : n;
  }
  std::span<const std::unique_ptr<Shape>> clips() const final { return clips_of(guards_.get()); }
  Box3 bounds() const final { return cold_->bounds; }
  SolidExtent solid_extent() const final {
    return cold_->solid ? *cold_->solid : SolidExtent{bounds(), solid_outside_};
  }

  // The inside formula with inversion; shapes whose inverted form is not the plain complement hide it.
  bool formula(const Vec3& p) const { return derived().contains(p) != inverted_; }

 protected:
  Primitive(const scene::Object& description, const LocalBox& local);

  bool inverted() const { return inverted_; }
  bool has_matrix() const { return has_matrix_; }
  const Guards* guards() const { return guards_.get(); }
  // The nearest hit of those that intersections(sink) reports; `any`: the first.
  template <class Intersections>
  bool nearest_of(const Ray& ray, double t_min, double t_max, Hit& hit, bool any, Intersections&& intersections) const {
    if (guards_ && !guards_->admit(ray)) return false;
    NearestHit sink(*this, guards_.get(), t_min, t_max, hit, any);
    intersections(sink);
    return sink.found();
  }
  const Transform& matrix() const { return *matrix_; }

  // The ray in the shape's space; unchanged (and not normalised) when the object has no matrix.
  LocalRay local(const Ray& ray) const {
    if (!has_matrix_) return {ray.origin, ray.direction, 1};
    const Vec3 d = matrix().inverse_direction(ray.direction);
    const double scale = length(d);
    return {matrix().inverse_point(ray.origin), d * (1.0 / scale), scale};
  }
  // The same for shapes that POV-Ray gives a matrix even where none is written: the direction is always divided by its
  // length, which shows in the last bits of a depth (spec 08 B).
  LocalRay unit_local(const Ray& ray) const {
    const Vec3 d = has_matrix_ ? matrix().inverse_direction(ray.direction) : ray.direction;
    const double scale = length(d);
    return {has_matrix_ ? matrix().inverse_point(ray.origin) : ray.origin, d * (1.0 / scale), scale};
  }
  Vec3 local(const Vec3& p) const { return has_matrix_ ? matrix().inverse_point(p) : p; }
  Vec3 world(const Vec3& p) const { return has_matrix_ ? matrix().point(p) : p; }
  // A local normal of any length as a unit world normal.
  Vec3 world_normal(const Vec3& n) const { return normalize(has_matrix_ ? matrix().normal(n) : n); }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
  void all_of(const Ray& ray, AllHits&& sink, HitList& hits) const {
    const auto begin = static_cast<std::ptrdiff_t>(hits.size());
    derived().intersections(ray, sink);
    if (turned_) std::reverse(hits.begin() + begin, hits.end());
  }

  // Apart, so that the numbers of a shape fit in a cache line or two.
  struct Cold {
    scene::Rare<Transform> matrix;  // shared with the description
    Box3 bounds;
    std::unique_ptr<const SolidExtent> solid;  // null: its box is that of the surface
  };

  std::unique_ptr<const Guards> guards_;
  std::unique_ptr<const Cold> cold_;
  const Transform* matrix_;  // the identity where there is none
  bool inverted_, has_matrix_, solid_outside_ = false, turned_ = false;
};

// The part of `box` that can lie inside every clip object.
void narrow(Box3& box, const Guards& guards);
// `box` under an object's matrix and narrowed to its clips: where its surface can be.
Box3 surface_bounds(const scene::Object& object, const Box3& local, const Guards* guards);
SolidExtent surface_solid(const scene::Object& object, const LocalBox& local, const Guards* guards);

template <class Derived>
Primitive<Derived>::Primitive(const scene::Object& description, const LocalBox& local)
    : Shape(description),
      guards_(Guards::of(description)),
      inverted_(description.inverted),
      has_matrix_(description.transform.has_value()) {
  const Box3 bounds = surface_bounds(description, local.box, local.clips_narrow ? guards_.get() : nullptr);
  const SolidExtent solid = surface_solid(description, local, guards_.get());
  solid_outside_ = solid.outside;
  cold_ = std::make_unique<Cold>(
      Cold{description.transform, bounds, solid.box == bounds ? nullptr : std::make_unique<SolidExtent>(solid)});
  matrix_ = &*cold_->matrix;
}

}  // namespace verisim::shapes
