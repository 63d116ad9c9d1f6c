// intersection, and with it difference (spec 03 section 5).
#include <algorithm>
#include <bit>
#include <utility>

#include "tracer/shapes/convex.h"
#include "tracer/shapes/csg/csg.h"
#include "tracer/shapes/csg/csg_tree.h"
#include "tracer/shapes/tree_on_demand.h"
#include "tracer/shapes/half_spaces.h"
#include "tracer/shapes/csg/interior_proxy.h"
#include "tracer/shapes/quadrics/plane_set.h"
#include "tracer/shapes/quadrics/quadric_box.h"

namespace verisim::shapes {
namespace {

class Intersection final : public CsgShape {
 public:
  Intersection(const scene::Object& description, Children children) : CsgShape(description, std::move(children)) {
    Box3 sheet, solid = everywhere(), complement;
    std::vector<HalfSpace> half_spaces;
    for (std::uint32_t i = 0; i < children_.size(); ++i) {
      sheet = united(sheet, children_[i]->bounds());
      if (const auto plane = plain_plane(*children_[i]->object)) {
        half_spaces.push_back(*half_space_of(*children_[i]->object));
        if (!planes_.full()) {
          planes_.add(plane->normal, plane->distance, children_[i]->object->inverted);
          plane_children_.push_back(i);
          continue;
        }
      }
      if (const auto* convex = dynamic_cast<const Convex*>(children_[i].get());
          convex && !core_ && convex->crossed_once())
        core_ = convex, core_child_ = i;
      else
        surfaces_.add(i, children_[i]->bounds());
      const SolidExtent extent = children_[i]->solid_extent();
      if (extent.outside) {
        complement = united(complement, extent.box);
        holes_.add(i, extent.box);
      } else {
        bounded_ = true;
        solid = common(solid, extent.box);
        solids_.push_back({i, extent.box});
      }
    }
    surfaces_.build();
    holes_.build();
    if (!half_spaces.empty()) bounded_ = true, solid = narrowed(solid, half_spaces);
    for (const auto& child : children_)
      if (const auto* quadric = child->object->as<scene::Quadric>()) solid = narrowed(solid, *quadric);
    if (bounded_) sheet = common(sheet, solid);
    set_extent(sheet, bounded_ ? SolidExtent{solid, false} : SolidExtent{complement, true});
    limit_ = bounded_ ? solid : everywhere();
    for (const auto& child : children_) nested_.push_back(!child->children().empty());
    // Between planes, and mostly within a convex child; what else cuts off a first hit makes all of them be asked for
    // again.
    firsts_survive_ = core_ || static_cast<std::size_t>(planes_.size()) + 1 == children_.size();
    find_proxies();
  }

  void intersect_all(const Ray& ray, RayKind kind, HitList& hits) const override {
    if (asks_all(ray))
      return all_of_children(
          ray, kind, hits, [](std::uint32_t) { return true; },
          [&](const Vec3& p, std::uint32_t i) { return inside_others(p, i); });
    Way way;
    if (!find_way(ray, 0, 2e10, way)) return;
    each_child_met(ray, way, [&](std::uint32_t i, const double* t) {
      const std::size_t begin = hits.size();
      if (t)
        add_plane_hit(ray, i, *t, hits);
      else
        child(i).intersect_all(ray, kind, hits);
      filter(hits, begin, [&](const Vec3& p) { return inside_others(p, i); });
    });
  }

  bool intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const override {
    if (asks_all(ray)) return nearest_of_all(ray, kind, t_min, t_max, hit);
    if (const CsgTree* tree = this->tree())
      return tree->nearest(ray, {kind, t_min, &t_max, guards_.get(), nullptr}, hit);
    Way way;
    return find_way(ray, t_min, t_max, way) && nearest(ray, kind, t_min, t_max, way, hit);
  }
  bool intersect_clipped(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips& clips,
                         Hit& hit) const override {
    if (asks_all(ray)) return nearest_of_all(ray, kind, t_min, t_max, hit, &clips);
    if (const CsgTree* tree = this->tree())
      return tree->nearest(ray, {kind, t_min, &t_max, guards_.get(), &clips}, hit);
    Way way;
    return find_way(ray, t_min, t_max, way) && nearest(ray, kind, t_min, t_max, way, hit, &clips);
  }
  bool occludes(const Ray& ray, double t_min, double t_max) const override {
    if (Hit hit; asks_all(ray)) return nearest_of_all(ray, RayKind::shadow, t_min, t_max, hit);
    if (const CsgTree* tree = this->tree())
      return tree->occluded(ray, {RayKind::shadow, t_min, &t_max, guards_.get(), nullptr});
    Way way;
    return find_way(ray, t_min, t_max, way) && blocks(ray, t_min, t_max, way);
  }

  // The box and the planes decide for all rays at once which of them need be looked at.
  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (std::popcount(rays.active) < CsgTree::kMin || asks_all(rays))
      return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    if (const CsgTree* tree = this->tree())
      return tree->nearest(rays, {kind, t_min, t_max, guards_.get(), nullptr}, hits);
    unsigned found = 0;
    each_way(rays, t_min, t_max, [&](int k, const Ray& ray, Way& way) {
      found |= nearest(ray, kind, t_min, t_max[k], way, hits[k]) ? 1u << k : 0;
    });
    return found;
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (std::popcount(rays.active) < CsgTree::kMin || asks_all(rays))
      return Shape::occludes_packet(rays, entry, t_min, t_max);
    if (const CsgTree* tree = this->tree())
      return tree->occluded(rays, {RayKind::shadow, t_min, t_max, guards_.get(), nullptr});
    unsigned found = 0;
    each_way(rays, t_min, t_max,
             [&](int k, const Ray& ray, Way& way) { found |= blocks(ray, t_min, t_max[k], way) ? 1u << k : 0; });
    return found;
  }

  bool inside_unclipped(const Vec3& p) const override { return inside_others(p, ~0u); }

 private:
  struct Solid {
    std::uint32_t child;
    Box3 box;
  };

  bool nearest_of_all(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit,
                      const Clips* clips = nullptr) const {
    return CsgShape::nearest_of_all(
        ray, kind, t_min, t_max, clips, hit, [](std::uint32_t) { return true; },
        [&](const Vec3& p, std::uint32_t self) { return inside_others(p, self); });
  }

  // Of few and mostly simple parts (else null): finds the same in less time.
  const CsgTree* tree() const {
    return tree_.get([&] { return CsgTree::of(*this, children_, limit_, proxies_); });
  }

  // Where a ray may meet the surface.
  struct Way {
    double enter, leave;    // where it may be inside all planes
    double near, far;       // and inside the box
    Intersections core;     // of the convex child
    std::uint64_t met = 0;  // the planes that it meets, at t
    alignas(64) double t[PlaneSet::kMax];
  };
  bool find_way(const Ray& ray, double t_min, double t_max, Way& way) const {
    way.near = t_min, way.far = t_max;
    if (bounded_ && !accel::clip_to_box(ray, limit_, way.near, way.far)) return false;
    way.enter = t_min, way.leave = t_max;
    way.met = planes_.meet(ray, way.t, way.enter, way.leave);
    way.near = std::max(way.near, way.enter), way.far = std::min(way.far, way.leave);
    if (!(way.near <= way.far) || (guards_ && !guards_->admit(ray)) || within_proxy(ray, way.near, way.far))
      return false;
    if (!core_) return true;
    way.core = core_->cross(ray);
    return narrow(way);
  }
  // To where the ray may be inside the convex child. False: nowhere.
  static bool narrow(Way& way) {
    way.enter = std::max(way.enter, way.core.near), way.leave = std::min(way.leave, way.core.far);
    way.near = std::max(way.near, way.core.near), way.far = std::min(way.far, way.core.far);
    return way.near <= way.far;
  }
  template <class Visit>
  void each_way(const RayPacket& rays, double t_min, const double* t_max, Visit&& visit) const {
    alignas(64) double near[RayPacket::kCount], far[RayPacket::kCount], enter[RayPacket::kCount],
        leave[RayPacket::kCount];
    std::fill_n(near, RayPacket::kCount, t_min), std::copy_n(t_max, RayPacket::kCount, far);
    std::copy_n(near, RayPacket::kCount, enter), std::copy_n(far, RayPacket::kCount, leave);
    if (bounded_) planes_.clip(limit_, rays, near, far);
    unsigned open = within(near, far, rays.active);
    if (open == 0) return;
    PlaneSet::Lanes planes;
    planes_.meet(rays, planes, enter, leave);
    for (int k = 0; k < RayPacket::kCount; ++k)
      near[k] = std::max(near[k], enter[k]), far[k] = std::min(far[k], leave[k]);
    open = within(near, far, open);
    if (guards_ && open != 0) open = guards_->admit({rays.rays, rays.first, open});
    if (!proxies_.empty())
      each_lane(open, [&](int k) { open &= within_proxy(rays.at(k), near[k], far[k]) ? ~(1u << k) : ~0u; });
    Intersections core[RayPacket::kCount];
    if (core_ && open != 0) core_->cross_packet({rays.rays, rays.first, open}, core);
    each_lane(open, [&](int k) {
      const Ray ray = rays.at(k);
      Way way;
      way.enter = enter[k], way.leave = leave[k], way.near = near[k], way.far = far[k];
      if (core_) {
        way.core = core[k];
        if (!narrow(way)) return;
      }
      for (int i = 0; i < planes_.size(); ++i)
        way.t[i] = planes.t[i][k], way.met |= std::uint64_t{planes.met[i] >> k & 1u} << i;
      visit(k, ray, way);
    });
  }
  static unsigned within(const double* near, const double* far, unsigned active) {
    unsigned lanes = 0;
    for (int k = 0; k < RayPacket::kCount; ++k) lanes |= near[k] <= far[k] ? 1u << k : 0;
    return lanes & active;
  }

  // Convex children that are taken away and leave little of the solid's box.
  void find_proxies() {
    constexpr double kSmallest = 0.1;  // of the box
    for (const auto& child : children_) {
      const Box3 box = common(child->bounds(), limit_);
      if (!child->object->inverted || accel::is_empty(box) || !(volume(box) >= kSmallest * volume(limit_))) continue;
      if (const auto proxy = InteriorProxy::of(*child->object)) proxies_.push_back(*proxy);
    }
  }
  static double volume(const Box3& box) {
    return (box.max.x - box.min.x) * (box.max.y - box.min.y) * (box.max.z - box.min.z);
  }
  bool within_proxy(const Ray& ray, double near, double far) const {
    return std::any_of(proxies_.begin(), proxies_.end(),
                       [&](const InteriorProxy& proxy) { return proxy.holds(ray, near, far); });
  }

  // A hit that a plane cuts away for sure: its point is that of the ray there. Whose points lie elsewhere strays, and
  // all is asked.
  static bool outside_planes(const Way& way, const Hit& hit) { return hit.t < way.enter || hit.t > way.leave; }

  bool nearest(const Ray& ray, RayKind kind, double t_min, double t_max, Way& way, Hit& hit,
               const Clips* clips = nullptr) const {
    const auto survives = [&](const Vec3& p, std::uint32_t self) {
      return inside_others(p, self) && within_clips(p, clips);
    };
    const bool core_known = way.core.count > 0;
    if (core_known) keep_first(ray, t_min, t_max, way, survives);
    ScratchOwners owners;
    ScratchHits hits;
    bool surely = true;
    const auto collect = [&](bool firsts) {
      each_child_met(ray, way, [&](std::uint32_t i, const double* t) {
        std::size_t kept = hits.end();
        if (t) {
          if (*t >= t_min && *t < t_max) add_plane_hit(ray, i, *t, hits.list());
        } else if (is_core(i)) {
          for (int n = 0; n < way.core.count; ++n) add_plane_hit(ray, i, way.core.t[n], hits.list());
        } else if (firsts && nested_[i]) {
          if (Hit first; child(i).intersect(ray, kind, std::max(t_min, way.enter),
                                            std::min(t_max, std::nextafter(way.leave, HUGE_VAL)), first))
            hits.list().push_back(first);
        } else {
          child(i).intersect_all(ray, kind, hits.list());
          for (std::size_t n = kept; n < hits.end(); ++n)
            if (!outside_planes(way, hits[n])) hits[kept++] = hits[n];
          hits.list().resize(kept);
        }
        while (owners.size() < hits.end() - hits.begin()) owners.add(i);
      });
      return nearest_surviving(hits, owners, t_min, t_max, hit, [&](const Vec3& p, std::uint32_t self) {
        if ((core_known && is_core(self)) || survives(p, self)) return true;
        surely = !(firsts && nested_[self]);  // what is behind it may survive
        return !surely;
      });
    };
    const bool found = collect(firsts_survive_);
    if (surely) return found;
    hits.list().resize(hits.begin());
    while (owners.size() > 0) owners.pop();
    return collect(false);
  }
  // Leaves the first hit of the convex child that survives, and what is not behind it.
  template <class Survives>
  void keep_first(const Ray& ray, double t_min, double t_max, Way& way, Survives&& survives) const {
    Intersections& core = way.core;
    const int count = std::exchange(core.count, 0);
    for (int n = 0; n < count && core.count == 0; ++n)
      if (core.t[n] >= t_min && core.t[n] < t_max && survives(ray.origin + core.t[n] * ray.direction, core_child_))
        core.add(core.t[n]);
    if (core.count > 0) way.far = std::min(way.far, core.t[0]), way.leave = std::min(way.leave, core.t[0]);
  }
  // Any hit survives.
  bool blocks(const Ray& ray, double t_min, double t_max, const Way& way) const {
    bool found = false;
    const auto survives = [&](double t, const Vec3& p, std::uint32_t self) {
      return t >= t_min && t < t_max && inside_others(p, self) && within_clips(p, nullptr);
    };
    each_child_met(ray, way, [&](std::uint32_t i, const double* t) {
      if (found) return;
      if (t) {
        found = survives(*t, ray.origin + *t * ray.direction, i);
        return;
      }
      ScratchHits hits;
      child(i).intersect_all(ray, RayKind::shadow, hits.list());
      for (std::size_t n = hits.begin(); n < hits.end() && !found; ++n) {
        const Hit hit = hits[n];  // inside tests may grow the list
        found = survives(hit.t, hit.point, i) && !outside_planes(way, hit);
      }
    });
    return found;
  }

  // Calls visit(child, t) for the children that the ray may meet, in their order; t is null for those that must be
  // asked, and the distance of a plane.
  template <class Visit>
  void each_child_met(const Ray& ray, const Way& way, Visit&& visit) const {
    std::uint64_t met = way.met;
    const auto planes_before = [&](std::uint32_t end) {
      for (; met != 0; met &= met - 1) {
        const int k = std::countr_zero(met);
        if (plane_children_[static_cast<std::size_t>(k)] >= end) return;
        if (way.t[k] >= way.near && way.t[k] <= way.far) visit(plane_children_[static_cast<std::size_t>(k)], way.t + k);
      }
    };
    bool core_waits = core_ != nullptr;
    const auto all_before = [&](std::uint32_t end) {
      if (core_waits && core_child_ < end) {
        core_waits = false;
        planes_before(core_child_);
        visit(core_child_, nullptr);
      }
      planes_before(end);
    };
    surfaces_.in_order(ray, way.near, way.far, [&](std::uint32_t i) {
      all_before(i);
      visit(i, nullptr);
    });
    all_before(~0u);
  }
  bool is_core(std::uint32_t i) const { return core_ && i == core_child_; }
  void add_plane_hit(const Ray& ray, std::uint32_t i, double t, HitList& hits) const {
    hits.push_back({t, ray.origin + t * ray.direction, &child(i), 0, 0, 0});
  }

  bool inside_others(const Vec3& p, std::uint32_t self) const {
    for (std::uint64_t outside = planes_.outside(p); outside != 0; outside &= outside - 1)
      if (plane_children_[static_cast<std::size_t>(std::countr_zero(outside))] != self) return false;
    for (const Solid& s : solids_)
      if (s.child != self && !(accel::contains(s.box, p) && child(s.child).inside(p))) return false;
    return !holes_.any_around(p, [&](std::uint32_t i) { return i != self && !child(i).inside(p); });
  }

  PlaneSet planes_;                            // of the children that are plain planes
  std::vector<std::uint32_t> plane_children_;  // which those are
  std::vector<Solid> solids_;                  // nothing outside their boxes is inside them
  ChildIndex holes_;                           // everything outside their boxes is
  Box3 limit_;
  bool bounded_ = false;
  const Convex* core_ = nullptr;  // a child that rays cross once: asked first
  std::uint32_t core_child_ = 0;
  std::vector<bool>
      nested_;  // the children that are CSG objects: their first hit is the only one that matters, if it survives
  bool firsts_survive_ = false;
  std::vector<InteriorProxy> proxies_;
  TreeOnDemand tree_;
};

}  // namespace

std::unique_ptr<Shape> make_intersection(const scene::Object& description, Children children) {
  return std::make_unique<Intersection>(description, std::move(children));
}

}  // namespace verisim::shapes
