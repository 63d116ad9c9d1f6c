// One ray in the world.
#include "tracer/world/world_impl.h"
#include "tracer/shapes/scratch_hits.h"

namespace verisim::accel {

// The search for the nearest hit of one ray.
class World::Search {
 public:
  Search(const Impl& world, const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit)
      : w_(world), ray_(ray), kind_(kind), mask_(bit(kind)), t_min_(t_min), limit_(t_max), hit_(hit) {}

  bool found() const { return found_; }
  bool before_box() const { return before_box_; }
  double limit() const { return limit_; }
  const Coincidences* coincidences() const { return coincident_ ? &coincidences_ : nullptr; }

  // Entries beside the tree.
  void test_unbounded() {
    for (std::size_t i = 0; i < w_.unbounded.size(); ++i) {
      const std::uint32_t index = w_.unbounded[i];
      const Entry& e = w_.entries[index];
      if (e.hidden & mask_) continue;
      if (w_.planes[i]) {
        const double t = w_.planes[i]->distance_along(ray_);
        if (t >= t_min_ && t < limit_) take({t, ray_.origin + t * ray_.direction, e.shape, 0, 0, 0}, index);
        continue;
      }
      if (!e.may_meet(ray_, t_min_, limit_)) continue;
      test(*e.shape, index, nullptr);
    }
  }
  void test_around() {
    for (const Surrounding& s : w_.around) {
      const Entry& e = w_.entries[s.entry];
      if (!(e.hidden & mask_) && !s.enclosure.holds(ray_, t_min_, limit_)) test(*e.shape, s.entry, nullptr);
    }
  }
  void test_imprecise() {
    w_.each_imprecise(ray_, best(), [this](std::uint32_t i, const Entry& e) {
      if (!(e.hidden & mask_)) test(*e.shape, i, nullptr);
    });
  }
  // All that POV-Ray asks, in its order: isosurfaces remember that they were asked.
  void test_in_turn() {
    const auto ask = [&](std::uint32_t index) {
      const Entry& e = w_.entries[index];
      Hit other;
      if (!(e.hidden & mask_) && e.slab.passes(ray_) && nearest_of_all(e, other) && other.t < limit_)
        found_ = true, hit_ = other, limit_ = other.t;
      return limit_;
    };
    if (!w_.in_order) return w_.hierarchy().search(ray_, limit_, ask);
    // From afar, as media send rays, single precision has them meet boxes that they pass by, and searches for nothing.
    for (std::uint32_t i = 0; i < w_.entries.size(); ++i)
      if (w_.entries[i].slab.used || w_.entries[i].may_meet(ray_, t_min_, HUGE_VAL)) ask(i);
  }
  void test_candidate(std::uint32_t i, const WorldEntry* entry) {
    const Candidate& c = w_.bounded[i];
    if (!(c.hidden & mask_)) test(*c.shape, c.entry, entry ? entry->inner_of(i) : nullptr);
  }

 private:
  double best() const { return end_of_boxes(kind_, found_, limit_); }
  void take(const Hit& hit, std::uint32_t index) {
    const Standing standing(found_, hit_, hit);
    if (standing.coincident) {
      if (!coincident_) coincidences_.add(0, owner_, hit_);
      coincidences_.add(0, index, hit);
    }
    coincident_ = standing.coincident;
    if (!standing.nearer) return;
    found_ = true;
    hit_ = hit;
    owner_ = index;
    limit_ = std::min(limit_, with_coincident(hit.t));
  }
  // Each part of CSG is asked, however far it is.
  bool nearest_of_all(const Entry& e, Hit& hit) const {
    if (!e.object->as<scene::Csg>()) return e.shape->intersect(ray_, kind_, t_min_, HUGE_VAL, hit);
    shapes::ScratchHits hits;
    e.shape->intersect_all(ray_, kind_, hits.list());
    bool found = false;
    for (std::size_t i = hits.begin(); i < hits.end(); ++i)
      if (hits[i].t >= t_min_ && (!found || hits[i].t <= hit.t)) found = true, hit = hits[i];
    return found;
  }
  void test(const Shape& shape, std::uint32_t index, const EntryPoints* inner) {
    const std::uint32_t twins = w_.twins_of(index);
    if (twins == 0 || twins != twins_) {
      met_ = inner ? shape.intersect_from(*inner, ray_, kind_, t_min_, limit_, other_)
                   : shape.intersect(ray_, kind_, t_min_, limit_, other_);
      twins_ = twins;
    } else if (met_) {  // as its twin was, which was asked last
      other_.shape = &shape, met_ = other_.t < limit_;
    }
    if (!met_) return;
    const Impl::Admission admission = w_.admit(index, ray_, other_, best());
    if (admission == Impl::Admission::refused) return;
    before_box_ |= admission == Impl::Admission::before_box;
    take(other_, index);
  }

  const Impl& w_;
  const Ray& ray_;
  const RayKind kind_;
  const unsigned mask_;
  const double t_min_;
  double limit_;
  Hit& hit_;
  bool found_ = false;
  std::uint32_t owner_ = 0;
  Hit other_;  // of the entry that was asked last
  bool met_ = false;
  std::uint32_t twins_ = 0;  // its number (World::Impl::twins)
  bool coincident_ = false;  // another entry was hit in the same place
  Coincidences coincidences_;
  bool before_box_ = false;  // something was hit before its box
};

bool World::intersect_in_turn(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const {
  Search search(*impl_, ray, kind, t_min, t_max, hit);
  search.test_in_turn();
  return search.found();
}

bool World::intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit,
                      const WorldEntry* entry) const {
  const Impl& w = *impl_;
  if (w.searches_in_turn()) return intersect_in_turn(ray, kind, t_min, t_max, hit);
  Search search(w, ray, kind, t_min, t_max, hit);
  search.test_unbounded();
  w.traverse(
      ray, t_min, search.limit(),
      [&](std::uint32_t i, double) {
        search.test_candidate(i, entry);
        return search.limit();
      },
      entry);
  search.test_around();
  search.test_imprecise();
  if (search.before_box()) return intersect_in_turn(ray, kind, t_min, t_max, hit);
  if (search.coincidences()) w.settle(ray, 0, t_max, *search.coincidences(), hit);
  return search.found();
}

bool World::boxes_along(const Ray& ray, double t_min, double t_max, const WorldEntry* entry, BoxesAlong& boxes) const {
  const Impl& w = *impl_;
  if (w.searches_in_turn()) return false;
  if (!entry && !w.few.empty()) return false;  // they are found as soon as looked up
  return w.tree.boxes_along(ray, t_min, t_max, entry ? &entry->points : nullptr, boxes);
}

bool World::intersect_along(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit, const WorldEntry* entry,
                            const BoxesAlong& boxes, double travelled) const {
  const Impl& w = *impl_;
  Search search(w, ray, kind, t_min, t_max, hit);
  search.test_unbounded();
  // Distances of boxes have the rounding of a walk, in which the boxes have room for it.
  const double passed = travelled - boxes.start(), slack = w.tree.slack();
  const double behind = passed + t_min - slack;
  float farthest = round_up(passed + search.limit() + slack);
  for (const BoxesAlong::Met& met : boxes.all()) {
    if (met.near > farthest) break;
    if (round_up(met.far) < behind) continue;
    search.test_candidate(met.primitive, entry);
    farthest = round_up(passed + search.limit() + slack);
  }
  search.test_around();
  search.test_imprecise();
  if (search.before_box()) return intersect_in_turn(ray, kind, t_min, t_max, hit);
  if (search.coincidences()) w.settle(ray, 0, t_max, *search.coincidences(), hit);
  return search.found();
}

std::vector<const scene::Object*> World::coincident(const Ray& ray, RayKind kind, double t) const {
  const double near = t - kCoincident * t, far = with_coincident(t);
  std::vector<const scene::Object*> out;
  for (const Entry& entry : impl_->entries) {
    double from = near, to = far;
    if ((entry.hidden & bit(kind)) || !entry.shape || !clip_to_box(ray, entry.shape->bounds(), from, to)) continue;
    shapes::ScratchHits hits;
    entry.shape->intersect_all(ray, kind, hits.list());
    for (std::size_t i = hits.begin(); i < hits.end(); ++i) {
      const shapes::Surface* surface = hits[i].shape->surface;
      if (hits[i].t < near || hits[i].t > far || !surface) continue;
      if (std::ranges::find(out, surface->object) == out.end()) out.push_back(surface->object);
    }
  }
  return out;
}

std::vector<const scene::Object*> World::passed(const Ray& ray, RayKind kind, double t_max) const {
  std::vector<const scene::Object*> out;
  for (const Entry& entry : impl_->entries) {
    double from = 0, to = t_max;
    if ((entry.hidden & bit(kind)) || !entry.shape || entry.infinite ||
        !clip_to_box(ray, entry.shape->bounds(), from, to))
      continue;
    Hit hit;
    if (!entry.shape->intersect(ray, kind, 0, with_coincident(t_max), hit)) out.push_back(entry.object);
  }
  return out;
}

bool blocks_partly(const Shape& shape, const Ray& ray, double near, double far) {
  shapes::ScratchHits hits;
  shape.intersect_all(ray, RayKind::shadow, hits.list());
  for (std::size_t i = hits.begin(); i < hits.end(); ++i)
    if (hits[i].t >= near && hits[i].t < far && hits[i].shape->surface->opaque) return true;
  return false;
}

// Whether something opaque lies on one ray.
class World::Occlusion {
 public:
  Occlusion(const Impl& world, const Ray& ray, double t_min, double t_max)
      : w_(world), ray_(ray), above_(next_above(t_min)), t_max_(t_max) {}

  bool by_unbounded() const {
    for (std::size_t i = 0; i < w_.unbounded.size(); ++i) {
      const Entry& e = w_.entries[w_.unbounded[i]];
      if ((e.hidden & kMask) || e.opacity == Opacity::transparent) continue;
      if (w_.planes[i]) {
        const double t = w_.planes[i]->distance_along(ray_);
        if (t >= above_ && t < t_max_) return true;
        continue;
      }
      if (!e.may_meet(ray_, above_, t_max_)) continue;
      if (blocks(*e.shape, e.opacity, nullptr) && w_.admits_blocker(w_.unbounded[i], ray_, t_max_)) return true;
    }
    return false;
  }
  bool by_surrounding() const {
    for (const Surrounding& s : w_.around) {
      const Entry& e = w_.entries[s.entry];
      if ((e.hidden & kMask) || e.opacity == Opacity::transparent || s.enclosure.holds(ray_, above_, t_max_)) continue;
      if (blocks(*e.shape, e.opacity, nullptr) && w_.admits_blocker(s.entry, ray_, t_max_)) return true;
    }
    return false;
  }
  bool by_imprecise() const {
    bool blocked = false;
    w_.each_imprecise(ray_, end_of_boxes(RayKind::shadow, false, t_max_), [&](std::uint32_t, const Entry& e) {
      blocked =
          blocked || (!(e.hidden & kMask) && e.opacity != Opacity::transparent && blocks(*e.shape, e.opacity, nullptr));
    });
    return blocked;
  }
  bool by_candidate(std::uint32_t i, const WorldEntry* entry) const {
    const Candidate& c = w_.bounded[i];
    return !(c.hidden & kMask) && c.opacity != Opacity::transparent &&
           blocks(*c.shape, c.opacity, entry ? entry->inner_of(i) : nullptr) &&
           w_.admits_blocker(c.entry, ray_, t_max_);
  }

 private:
  static constexpr unsigned kMask = 1u << static_cast<unsigned>(RayKind::shadow);

  bool blocks(const Shape& shape, Opacity opacity, const EntryPoints* inner) const {
    if (opacity == Opacity::opaque)
      return inner ? shape.occludes_from(*inner, ray_, above_, t_max_) : shape.occludes(ray_, above_, t_max_);
    return blocks_partly(shape, ray_, above_, t_max_);
  }

  const Impl& w_;
  const Ray& ray_;
  const double above_, t_max_;
};

bool World::occluded(const Ray& ray, double t_min, double t_max, WorldEntry* entry) const {
  const Impl& w = *impl_;
  const Occlusion occlusion(w, ray, t_min, t_max);
  if (entry && entry->last_blocker != WorldEntry::kNoBlocker && occlusion.by_candidate(entry->last_blocker, entry))
    return true;
  if (occlusion.by_unbounded() || occlusion.by_surrounding() || occlusion.by_imprecise()) return true;
  if (!entry && !w.few.empty())
    return w.few.any_along(ray, t_min, t_max, [&](std::uint32_t i) { return occlusion.by_candidate(i, nullptr); });
  bool found = false;
  w.tree.traverse(
      ray, t_min, t_max,
      [&](std::uint32_t i, double far) {
        if (!occlusion.by_candidate(i, entry)) return far;
        found = true;
        if (entry) entry->last_blocker = i;
        return -HUGE_VAL;
      },
      entry ? &entry->points : nullptr);
  return found;
}

}  // namespace verisim::accel
