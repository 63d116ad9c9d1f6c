// Batches of rays in the world, eight at a time: objects are asked in the order in which the eight meet their boxes,
// each for all rays that it may still concern. What is found is what one ray finds alone, because the world decides
// ties by rules of its own.
#include <algorithm>
#include <optional>

#include "tracer/world/world_impl.h"

namespace verisim::accel {
namespace {

constexpr int kLanes = RayPacket::kCount;

// One lane, or none. (Where there is no instruction that counts bits, std::has_single_bit is a call.)
bool is_alone(unsigned lanes) { return (lanes & (lanes - 1)) == 0; }
unsigned lanes_below(int count) { return count < kLanes ? (1u << count) - 1 : (1u << kLanes) - 1; }

NodeRays rays_in(const Bvh& tree, const RayPacket& rays, double t_min) {
  NodeRays there;
  batch_kernels().node_rays(tree.bounds(), tree.center(), tree.slack(), rays.rays, rays.first, t_min, there);
  return there;
}

// The boxes that eight rays meet before their limits, nearest first as far as one ray can tell.
class Places {
 public:
  Places(const Bvh& tree, const EntryPoints& entry, const RayPacket& rays, double t_min, const double* limit)
      : entry_(entry), there_(rays_in(tree, rays, t_min)) {
    for (int n = 0; n < entry.count; ++n) {
      batch_kernels().children(entry.nodes[n], there_, limit, met_[n]);
      for (int k = 0; k < 4; ++k) {
        met_[n].lanes[k] &= rays.active;
        if (met_[n].lanes[k] != 0) insert(4 * n + k, met_[n].near[k][std::countr_zero(met_[n].lanes[k])]);
      }
    }
  }
  int count() const { return count_; }
  std::uint32_t candidate(int i) const { return BoxNode::leaf_first(entry_.nodes[order_[i] / 4].child[order_[i] % 4]); }
  // The lanes that meet box i before their limits, which may have shrunk.
  unsigned lanes(int i, const double* limit) const {
    const ChildrenMet& met = met_[order_[i] / 4];
    const int k = order_[i] % 4;
    return met.lanes[k] & batch_kernels().before(met.near[k], there_, limit);
  }

 private:
  void insert(int place, float near) {
    int at = count_++;
    for (; at > 0 && distance_[at - 1] > near; --at) order_[at] = order_[at - 1], distance_[at] = distance_[at - 1];
    order_[at] = static_cast<std::uint8_t>(place), distance_[at] = near;
  }

  const EntryPoints& entry_;
  const NodeRays there_;
  ChildrenMet met_[EntryPoints::kNodes];
  std::uint8_t order_[EntryPoints::kMax];
  float distance_[EntryPoints::kMax];
  int count_ = 0;
};

// Rays of a packet that go through nodes without the others: as the formula for one ray takes them.
class LoneRays {
 public:
  explicit LoneRays(const NodeRays& there) : there_(there) {}
  unsigned test(const BoxNode& node, int lane, double limit, float near[4]) {
    std::optional<NodeRay>& ray = rays_[lane];
    const auto at = [&](const NodeRays::Lane* v) { return Vec3(v[0][lane], v[1][lane], v[2][lane]); };
    if (!ray) ray.emplace(at(there_.origin), at(there_.inverse));
    return ray->test(node, far(lane, limit), near);
  }
  // A limit counted from where the ray enters the tree.
  float far(int lane, double limit) const { return round_up(limit - there_.start[lane] + there_.slack); }

 private:
  const NodeRays& there_;
  std::optional<NodeRay> rays_[kLanes];
};

void prefetch(const BoxNode& node) {
  __builtin_prefetch(node.planes[0]);
  __builtin_prefetch(node.planes[4]);
}

// Walks a tree with eight rays, from the subtrees of an entry or from the root. Calls visit(candidate, lanes) for the
// boxes that lanes of `open` meet before their limits, which may shrink meanwhile, roughly from near to far. `ahead`
// tells of candidates before they are visited, if they are: first soon, then next.
template <class Ahead, class Visit>
void walk(const Bvh& tree, const EntryPoints* entry, const RayPacket& rays, double t_min, const double* limit,
          const unsigned& open, const Ahead& ahead, Visit&& visit) {
  // A child and its lanes are one number: two that are stored apart and moved together would have to be waited for.
  std::uint64_t stack[Bvh::kStackSize];
  float nearest[Bvh::kStackSize];
  const auto child_of = [](std::uint64_t item) { return static_cast<std::uint32_t>(item); };
  const auto lanes_of = [](std::uint64_t item) { return static_cast<unsigned>(item >> 32); };
  int size = 0;
  const NodeRays there = rays_in(tree, rays, t_min);
  LoneRays lone(there);
  ChildrenMet met;
  // Among those above `first`, the nearest on top.
  const auto put = [&](std::uint32_t child, unsigned lanes, float near, int first) {
    int at = size++;
    for (; at > first && nearest[at - 1] < near; --at) stack[at] = stack[at - 1], nearest[at] = nearest[at - 1];
    stack[at] = std::uint64_t{lanes} << 32 | child, nearest[at] = near;
    if (child & BoxNode::kLeaf)
      ahead.soon(BoxNode::leaf_first(child));
    else
      prefetch(tree.node(child));
  };
  const auto expand = [&](const BoxNode& node, unsigned lanes) {
    const int first = size;
    if (is_alone(lanes)) {
      const int lane = std::countr_zero(lanes);
      alignas(16) float near[4];
      each_lane(lone.test(node, lane, limit[lane], near), [&](int k) { put(node.child[k], lanes, near[k], first); });
      return;
    }
    batch_kernels().children(node, there, limit, met);
    for (int k = 0; k < 4; ++k)
      if (const unsigned here = met.lanes[k] & lanes; here != 0)
        put(node.child[k], here, met.near[k][std::countr_zero(here)], first);
  };
  if (entry) {
    for (int n = entry->count - 1; n >= 0; --n) expand(entry->nodes[n], open);
  } else {
    expand(tree.node(0), open);
  }
  while (size > 0) {
    const std::uint64_t item = stack[--size];
    const std::uint32_t child = child_of(item);
    const unsigned lanes = lanes_of(item) & open;
    if (lanes == 0) continue;
    if (is_alone(lanes_of(item))) {
      const int lane = std::countr_zero(lanes);
      if (!(nearest[size] <= lone.far(lane, limit[lane]))) continue;
    }
    if (size > 0 && child_of(stack[size - 1]) & BoxNode::kLeaf)
      ahead.next(BoxNode::leaf_first(child_of(stack[size - 1])));
    if (child & BoxNode::kLeaf)
      visit(BoxNode::leaf_first(child), lanes);
    else
      expand(tree.node(child), lanes);
  }
}

// Shapes lie about in memory: they are on their way while others are asked.
struct Prefetch {
  const Candidate* candidates;
  void soon(std::uint32_t i) const { __builtin_prefetch(candidates + i); }
  void next(std::uint32_t i) const {
    const auto* lines = reinterpret_cast<const char*>(candidates[i].shape);
    for (int line = 0; line < 3; ++line) __builtin_prefetch(lines + 64 * line);
  }
};

constexpr int kMin = 3;  // rays for which this costs less than one walk for each

// What was found out of entries that are met alike (World::Impl::twins).
struct LastMet {
  std::uint32_t twins = 0;
  unsigned asked = 0, met = 0;  // lanes
};

}  // namespace

// The search for the nearest hits of eight rays.
class World::BatchSearch {
 public:
  BatchSearch(const Impl& world, const RayPacket& rays, RayKind kind, double t_min, const double* t_max, Hit* hits)
      : w_(world), rays_(rays), kind_(kind), mask_(bit(kind)), t_min_(t_min), hits_(hits) {
    if (t_max)
      std::copy_n(t_max, kLanes, limit_);
    else
      std::fill_n(limit_, kLanes, kFarthestHit);
  }

  unsigned found() const { return found_; }
  unsigned coincident() const { return coincident_ & ~before_box_; }
  unsigned before_box() const { return before_box_; }
  const Coincidences& coincidences() const { return coincidences_; }

  void test_planes() {
    for (std::size_t i = 0; i < w_.unbounded.size(); ++i) {
      const std::uint32_t index = w_.unbounded[i];
      const Entry& e = w_.entries[index];
      if (w_.planes[i] && !(e.hidden & mask_)) test_plane(*w_.planes[i], e.shape, index);
    }
  }
  // What else is beside the tree, as far as rays begin outside it or not: from outside it is met before what the tree
  // holds, from within behind most of that.
  void test_unbounded(bool outside) {
    for (std::size_t i = 0; i < w_.unbounded.size(); ++i) {
      const std::uint32_t index = w_.unbounded[i];
      const Entry& e = w_.entries[index];
      if (w_.planes[i] || (e.hidden & mask_) || contains(e.box(), rays_.at(0).origin) == outside) continue;
      unsigned lanes = 0;
      each_lane(rays_.active, [&](int k) { lanes |= e.may_meet(rays_.at(k), t_min_, limit_[k]) ? 1u << k : 0; });
      if (lanes != 0) test(*e.shape, index, nullptr, lanes);
    }
  }
  void test_around() {
    for (const Surrounding& s : w_.around) {
      const Entry& e = w_.entries[s.entry];
      unsigned lanes = 0;
      if (!(e.hidden & mask_))
        each_lane(rays_.active,
                  [&](int k) { lanes |= s.enclosure.holds(rays_.at(k), t_min_, limit_[k]) ? 0 : 1u << k; });
      if (lanes != 0) test(*e.shape, s.entry, nullptr, lanes);
    }
  }
  void test_boxes(const WorldEntry& entry) {
    const Places places(w_.tree, entry.points, rays_, t_min_, limit_);
    for (int i = 0; i < places.count(); ++i) {
      const unsigned lanes = places.lanes(i, limit_) & rays_.active;
      if (lanes == 0) continue;
      const std::uint32_t candidate = places.candidate(i);
      test_candidate(candidate, &entry, lanes);
    }
  }
  void walk_tree(const WorldEntry* entry) {
    walk(w_.tree, entry ? &entry->points : nullptr, rays_, t_min_, limit_, rays_.active, Prefetch{w_.bounded.data()},
         [&](std::uint32_t candidate, unsigned lanes) { test_candidate(candidate, entry, lanes); });
  }

 private:
  // Lane k is hit before limit_[k].
  void take(int k, const Hit& hit, std::uint32_t index) {
    const unsigned lane = 1u << k;
    const Standing standing(found_ & lane, hits_[k], hit);
    if (standing.coincident) {
      if (!(coincident_ & lane)) coincidences_.add(k, owner_[k], hits_[k]);
      coincidences_.add(k, index, hit);
      coincident_ |= lane;
    } else {
      coincident_ &= ~lane;
    }
    if (!standing.nearer) return;
    hits_[k] = hit;
    __builtin_prefetch(hit.shape->surface);  // soon asked for
    owner_[k] = index;
    found_ |= lane;
    limit_[k] = std::min(limit_[k], with_coincident(hit.t));
  }
  void test_candidate(std::uint32_t i, const WorldEntry* entry, unsigned lanes) {
    const Candidate& c = w_.bounded[i];
    if (c.hidden & mask_) return;
    __builtin_prefetch(&w_.entries[c.entry].slab);
    test(*c.shape, c.entry, entry ? entry->inner_of(i) : nullptr, lanes);
  }
  void test_plane(const Plane& plane, const Shape* shape, std::uint32_t index) {
    alignas(64) double t[kLanes];
    const unsigned met =
        batch_kernels().plane(plane.normal, plane.distance, rays_.rays, rays_.first, t_min_, limit_, t);
    each_lane(met & rays_.active, [&](int k) {
      const Ray ray = rays_.at(k);
      take(k, {t[k], ray.origin + t[k] * ray.direction, shape, 0, 0, 0}, index);
    });
  }
  void test(const Shape& shape, std::uint32_t index, const EntryPoints* inner, unsigned lanes) {
    if (w_.twins_of(index) != 0)
      test_twin(shape, index, inner, lanes);
    else
      each_lane(meet(shape, inner, lanes), [&](int k) { take_admitted(k, rays_.at(k), index); });
  }
  // What its twin was found to meet, if that was asked last, it meets.
  void test_twin(const Shape& shape, std::uint32_t index, const EntryPoints* inner, unsigned lanes) {
    if (last_.twins != w_.twins_of(index) || (lanes & ~last_.asked) != 0)
      last_ = {w_.twins_of(index), lanes, meet(shape, inner, lanes)};
    each_lane(last_.met & lanes, [&](int k) {
      others_[k].shape = &shape;
      if (others_[k].t < limit_[k]) take_admitted(k, rays_.at(k), index);
    });
  }
  // Sets others_ of the lanes that meet it.
  unsigned meet(const Shape& shape, const EntryPoints* inner, unsigned lanes) {
    last_.twins = 0;
    if (!is_alone(lanes))
      return shape.intersect_packet({rays_.rays, rays_.first, lanes}, inner, kind_, t_min_, limit_, others_);
    const int k = std::countr_zero(lanes);
    const Ray ray = rays_.at(k);
    const bool met = inner ? shape.intersect_from(*inner, ray, kind_, t_min_, limit_[k], others_[k])
                           : shape.intersect(ray, kind_, t_min_, limit_[k], others_[k]);
    return met ? lanes : 0;
  }
  void take_admitted(int k, const Ray& ray, std::uint32_t index) {
    const Impl::Admission admission = w_.admit(index, ray, others_[k], best(k));
    if (admission == Impl::Admission::refused) return;
    if (admission == Impl::Admission::before_box) before_box_ |= 1u << k;
    take(k, others_[k], index);
  }

  double best(int k) const { return end_of_boxes(kind_, found_ >> k & 1, limit_[k]); }

  const Impl& w_;
  const RayPacket rays_;
  const RayKind kind_;
  const unsigned mask_;
  const double t_min_;
  Hit* const hits_;
  alignas(64) double limit_[kLanes];
  unsigned found_ = 0;
  unsigned coincident_ = 0;  // lanes in which another entry was hit in the same place
  unsigned before_box_ = 0;  // and in which something was hit before its box
  std::uint32_t owner_[kLanes];
  Coincidences coincidences_;
  Hit others_[kLanes];
  LastMet last_;  // whose hits are others_
};

void World::intersect_batch(const RayBatch& rays, int first, int count, RayKind kind, double t_min,
                            const WorldEntry* entry, Hit* hits, bool* found, const double* t_max) const {
  const Impl& w = *impl_;
  const bool all_known = w.tree.empty() || (entry && entry->points.complete);
  for (int start = first; start < first + count; start += kLanes) {
    const int rest = std::min(kLanes, first + count - start);
    if (rest < kMin || w.any_imprecise_for(rays, start, rest)) {
      for (int i = start; i < start + rest; ++i)
        found[i] = intersect(rays.at(i), kind, t_min, t_max ? t_max[i] : kFarthestHit, hits[i], entry);
      continue;
    }
    BatchSearch search(w, {rays, start, lanes_below(rest)}, kind, t_min, t_max ? t_max + start : nullptr, hits + start);
    search.test_planes();
    search.test_unbounded(true);
    if (!all_known)
      search.walk_tree(entry);
    else if (entry)
      search.test_boxes(*entry);
    search.test_unbounded(false);
    search.test_around();
    each_lane(search.coincident(), [&](int k) {
      const double far = t_max ? t_max[start + k] : kFarthestHit;
      w.settle(rays.at(start + k), k, far, search.coincidences(), hits[start + k]);
    });
    for (int k = 0; k < rest; ++k) found[start + k] = search.found() >> k & 1;
    each_lane(search.before_box(), [&](int k) {
      const double far = t_max ? t_max[start + k] : kFarthestHit;
      found[start + k] = intersect_in_turn(rays.at(start + k), kind, t_min, far, hits[start + k]);
    });
  }
}

// Whether something opaque lies on eight rays.
class World::BatchOcclusion {
 public:
  BatchOcclusion(const Impl& world, const RayPacket& rays, double t_min, const double* t_max)
      : w_(world), rays_(rays), open_(rays.active), t_min_(t_min), above_(next_above(t_min)), t_max_(t_max) {}

  unsigned open() const { return open_; }

  void test_planes() {
    for (std::size_t i = 0; i < w_.unbounded.size() && open_ != 0; ++i) {
      const Entry& e = w_.entries[w_.unbounded[i]];
      if (w_.planes[i] && !(e.hidden & kMask) && e.opacity != Opacity::transparent) test_plane(*w_.planes[i]);
    }
  }
  void test_unbounded() {
    for (std::size_t i = 0; i < w_.unbounded.size() && open_ != 0; ++i) {
      const Entry& e = w_.entries[w_.unbounded[i]];
      if (w_.planes[i] || (e.hidden & kMask) || e.opacity == Opacity::transparent) continue;
      unsigned lanes = 0;
      each_lane(open_, [&](int k) { lanes |= e.may_meet(rays_.at(k), above_, t_max_[k]) ? 1u << k : 0; });
      test(*e.shape, e.opacity, w_.unbounded[i], nullptr, lanes);
    }
  }
  void test_around() {
    for (const Surrounding& s : w_.around) {
      const Entry& e = w_.entries[s.entry];
      if ((e.hidden & kMask) || e.opacity == Opacity::transparent) continue;
      unsigned lanes = 0;
      each_lane(open_, [&](int k) { lanes |= s.enclosure.holds(rays_.at(k), above_, t_max_[k]) ? 0 : 1u << k; });
      test(*e.shape, e.opacity, s.entry, nullptr, lanes);
    }
  }
  void test_boxes(WorldEntry& entry) {
    const Places places(w_.tree, entry.points, rays_, t_min_, t_max_);
    const std::uint32_t last = entry.last_blocker;
    for (int i = 0; i < places.count() && open_ != 0; ++i) {
      const std::uint32_t candidate = places.candidate(i);
      if (candidate != last) test_candidate(candidate, &entry, places.lanes(i, t_max_) & open_);
    }
  }
  void walk_tree(WorldEntry* entry) {
    const std::uint32_t last = entry ? entry->last_blocker : WorldEntry::kNoBlocker;
    walk(w_.tree, entry ? &entry->points : nullptr, rays_, t_min_, t_max_, open_, Prefetch{w_.bounded.data()},
         [&](std::uint32_t candidate, unsigned lanes) {
           if (candidate != last) test_candidate(candidate, entry, lanes);
         });
  }
  // True if any lane is blocked by it.
  void test_candidate(std::uint32_t i, WorldEntry* entry, unsigned lanes) {
    const Candidate& c = w_.bounded[i];
    if ((c.hidden & kMask) || c.opacity == Opacity::transparent) return;
    __builtin_prefetch(&w_.entries[c.entry].slab);
    if (test(*c.shape, c.opacity, c.entry, entry ? entry->inner_of(i) : nullptr, lanes) && entry)
      entry->last_blocker = i;
  }

 private:
  static constexpr unsigned kMask = 1u << static_cast<unsigned>(RayKind::shadow);

  void test_plane(const Plane& plane) {
    alignas(64) double t[kLanes];
    open_ &= ~batch_kernels().plane(plane.normal, plane.distance, rays_.rays, rays_.first, above_, t_max_, t);
  }
  unsigned blocks(const Shape& shape, Opacity opacity, const EntryPoints* inner, unsigned lanes) const {
    if (opacity != Opacity::opaque) {
      unsigned blocked = 0;
      each_lane(lanes, [&](int k) { blocked |= blocks_partly(shape, rays_.at(k), above_, t_max_[k]) ? 1u << k : 0; });
      return blocked;
    }
    if (!is_alone(lanes)) return shape.occludes_packet({rays_.rays, rays_.first, lanes}, inner, above_, t_max_);
    const int k = std::countr_zero(lanes);
    const Ray ray = rays_.at(k);
    const bool met =
        inner ? shape.occludes_from(*inner, ray, above_, t_max_[k]) : shape.occludes(ray, above_, t_max_[k]);
    return met ? lanes : 0;
  }
  // True if any lane is blocked.
  bool test(const Shape& shape, Opacity opacity, std::uint32_t index, const EntryPoints* inner, unsigned lanes) {
    if (lanes == 0) return false;
    const std::uint32_t twins = opacity == Opacity::opaque ? w_.twins_of(index) : 0;
    if (twins == 0 || twins != last_.twins || (lanes & ~last_.asked) != 0)
      last_ = {twins, lanes, blocks(shape, opacity, inner, lanes)};
    unsigned blocked = last_.met & lanes;
    each_lane(blocked, [&](int k) { blocked &= w_.admits_blocker(index, rays_.at(k), t_max_[k]) ? ~0u : ~(1u << k); });
    open_ &= ~blocked;
    return blocked != 0;
  }

  const Impl& w_;
  const RayPacket rays_;
  unsigned open_;  // nothing is known to block these
  const double t_min_, above_;
  const double* const t_max_;
  LastMet last_;
};

void World::occluded_batch(const RayBatch& rays, int first, int count, double t_min, const double* t_max,
                           WorldEntry* entry, bool* blocked) const {
  const Impl& w = *impl_;
  const bool all_known = w.tree.empty() || (entry && entry->points.complete);
  for (int start = first; start < first + count; start += kLanes) {
    const unsigned active = lanes_below(first + count - start);
    if (const int rest = std::popcount(active); rest < kMin || w.any_imprecise_for(rays, start, rest)) {
      each_lane(active,
                [&](int k) { blocked[start + k] = occluded(rays.at(start + k), t_min, t_max[start + k], entry); });
      continue;
    }
    BatchOcclusion occlusion(w, {rays, start, active}, t_min, t_max + start);
    if (entry && entry->last_blocker != WorldEntry::kNoBlocker)
      occlusion.test_candidate(entry->last_blocker, entry, active);
    occlusion.test_planes();
    if (occlusion.open() != 0) {
      if (!all_known)
        occlusion.walk_tree(entry);
      else if (entry)
        occlusion.test_boxes(*entry);
    }
    occlusion.test_unbounded();
    occlusion.test_around();
    each_lane(active & ~occlusion.open(), [&](int k) { blocked[start + k] = true; });
  }
}

}  // namespace verisim::accel
