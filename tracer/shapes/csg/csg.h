// What union, merge, intersection and difference share (spec 03 section 5). A difference is an intersection whose later
// children are inverted; an inverted union arrives here as an intersection of inverted children.
//
// POV-Ray collects the hits of all children and keeps those that pass an inside test against the others. We do the same
// but look only at children whose boxes the ray meets, test candidates in increasing distance, and stop at the first
// that survives; but for isosurfaces with --replay, which remember that they were asked.
#pragma once

#include <algorithm>

#include "tracer/shapes/csg/child_index.h"
#include "tracer/shapes/implicit/last_miss.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/scratch.h"

namespace verisim::shapes {

using Children = std::vector<std::unique_ptr<Shape>>;

struct OwnerTag;
using ScratchOwners = Scratch<std::uint32_t, OwnerTag>;  // the child of each candidate hit

inline Box3 united(const Box3& a, const Box3& b) {
  Box3 box = a;
  if (!accel::is_empty(b)) box.extendBy(b);
  return box;
}
inline Box3 common(const Box3& a, const Box3& b) {
  Box3 box;
  for (int i = 0; i < 3; ++i) box.min[i] = std::max(a.min[i], b.min[i]), box.max[i] = std::min(a.max[i], b.max[i]);
  return box;
}

class CsgShape : public Shape {
 public:
  CsgShape(const scene::Object& description, Children children)
      : Shape(description), children_(std::move(children)), guards_(Guards::of(description)) {
    holds_isosurface_ = std::ranges::any_of(children_, [](const auto& c) { return holds_isosurface(*c); });
    for (const auto& c : children_)
      if (c->may_stray()) straying_.push_back(c.get());
  }

  bool may_stray() const final { return !straying_.empty(); }
  bool strays(const Ray& ray) const final {
    return std::ranges::any_of(straying_, [&](const Shape* child) { return child->strays(ray); });
  }
  bool inside(const Vec3& p) const final { return (!guards_ || guards_->contain(p)) && inside_unclipped(p); }
  Vec3 normal(const Hit&) const final { return Vec3(0); }  // hits belong to primitives
  std::span<const std::unique_ptr<Shape>> clips() const final { return clips_of(guards_.get()); }
  Box3 bounds() const final { return bounds_; }
  SolidExtent solid_extent() const final { return solid_; }
  std::span<const std::unique_ptr<Shape>> children() const final { return children_; }

 protected:
  const Shape& child(std::uint32_t i) const { return *children_[i]; }

  // POV-Ray asks all children, whatever the others have met, and wherever their boxes are. With --replay isosurfaces
  // remember each search (spec 04 6.3), and what strays out of its box may come before what is met sooner.
  bool asks_all(const Ray& ray) const { return (holds_isosurface_ && last_miss().kept) || strays(ray); }
  bool asks_all(const RayPacket& rays) const {
    if (straying_.empty()) return holds_isosurface_ && last_miss().kept;
    bool any = false;
    each_lane(rays.active, [&](int k) { any = any || asks_all(rays.at(k)); });
    return any;
  }
  static bool holds_isosurface(const Shape& shape) {
    return shape.object->as<std::shared_ptr<const scene::Isosurface>>() ||
           std::ranges::any_of(shape.children(), [](const auto& c) { return holds_isosurface(*c); });
  }
  // All hits of the children that `asked` lets be asked, which keep(point, child) accepts.
  template <class Asked, class Keep>
  void all_of_children(const Ray& ray, RayKind kind, HitList& hits, Asked&& asked, Keep&& keep) const {
    if (guards_ && !guards_->admit(ray)) return;
    for (std::uint32_t i = 0; i < children_.size(); ++i) {
      if (!asked(i)) continue;
      const std::size_t begin = hits.size();
      child(i).intersect_all(ray, kind, hits);
      filter(hits, begin, [&](const Vec3& p) { return keep(p, i); });
    }
  }
  template <class Asked, class Keep>
  bool nearest_of_all(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips* clips, Hit& hit,
                      Asked&& asked, Keep&& keep) const {
    if (guards_ && !guards_->admit(ray)) return false;
    ScratchOwners owners;
    ScratchHits hits;
    for (std::uint32_t i = 0; i < children_.size(); ++i) {
      if (!asked(i)) continue;
      child(i).intersect_all(ray, kind, hits.list());
      while (owners.size() < hits.end() - hits.begin()) owners.add(i);
    }
    return nearest_surviving(hits, owners, t_min, t_max, hit, [&](const Vec3& p, std::uint32_t self) {
      return keep(p, self) && within_clips(p, clips);
    });
  }

  // Drops hits from `begin` on that lie outside the clip objects or fail `keep`.
  template <class Keep>
  void filter(HitList& hits, std::size_t begin, Keep&& keep) const {
    std::size_t end = begin;
    for (std::size_t i = begin; i < hits.size(); ++i) {
      const Hit hit = hits[i];  // inside tests may grow the list
      if (keep(hit.point) && (!guards_ || guards_->contain(hit.point))) hits[end++] = hit;
    }
    hits.resize(end);
  }
  // p is inside the clip objects of this object and of those around it.
  bool within_clips(const Vec3& p, const Clips* outer) const {
    return (!guards_ || guards_->contain(p)) && (!outer || outer->contain(p));
  }
  // Of candidates whose `owner` says which child they came from: the nearest in range that keep(point, owner) accepts;
  // at equal t the last collected.
  template <class Keep>
  bool nearest_surviving(ScratchHits& hits, const ScratchOwners& owners, double t_min, double t_max, Hit& hit,
                         Keep&& keep) const {
    std::size_t count = 0;
    for (std::size_t i = hits.begin(); i < hits.end(); ++i) count += hits[i].t >= t_min && hits[i].t < t_max;
    if (count == 0) return false;
    double after = t_min;
    std::size_t after_index = hits.end();  // at t == after only candidates before this one remain
    while (count-- > 0) {
      std::size_t best = hits.end();
      for (std::size_t i = hits.begin(); i < hits.end(); ++i) {
        const double t = hits[i].t;
        if (!(t < t_max) || !(t > after || (t == after && i < after_index))) continue;
        if (best == hits.end() || t <= hits[best].t) best = i;
      }
      if (best == hits.end()) return false;
      const Hit candidate = hits[best];
      if (keep(candidate.point, owners[best - hits.begin()])) {
        hit = candidate;
        return true;
      }
      after = candidate.t;
      after_index = best;
    }
    return false;
  }
  void set_extent(const Box3& bounds, SolidExtent solid) {
    bounds_ = bounds;
    solid_ = solid;
    if (!guards_) return;
    if (solid_.outside && !guards_->clips.empty()) solid_ = {everywhere(), false};
    narrow(bounds_, *guards_);
    if (!solid_.outside) narrow(solid_.box, *guards_);
  }

  const Children children_;
  const std::unique_ptr<const Guards> guards_;
  ChildIndex surfaces_;
  Box3 bounds_;
  SolidExtent solid_;
  bool holds_isosurface_ = false;
  std::vector<const Shape*> straying_;  // the children that may
};

// intersection.cpp; the others are in csg.cpp.
std::unique_ptr<Shape> make_intersection(const scene::Object& description, Children children);

}  // namespace verisim::shapes
