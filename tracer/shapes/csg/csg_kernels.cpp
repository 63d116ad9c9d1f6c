#include "tracer/shapes/csg/csg_tree.h"
#include <algorithm>
#include <cmath>
#include "tracer/bvh/bvh.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/csg/csg_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/shapes/csg/csg_intersections-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

// `Number` is a packet of the rays that go together: Packet, or PacketOf<1>.

using namespace simd::HWY_NAMESPACE;

template <class Number>
HWY_INLINE Ray ray_of(const Search<Number>& s, int k) {
  return {lane_of(s.o, k), lane_of(s.d, k)};
}

template <class Number>
HWY_INLINE void clip_to(const Search<Number>& s, const Box3& box, Number& enter, Number& leave) {
  const auto clip = [&](const Number& o, const Number& inverse, double low, double high) VERISIM_INLINE_LAMBDA {
    const Number a = (Number(low) - o) * inverse, b = (Number(high) - o) * inverse;
    enter = max(enter, min(a, b)), leave = min(leave, max(a, b));
  };
  clip(s.o.x, s.reciprocal.x, box.min.x, box.max.x);
  clip(s.o.y, s.reciprocal.y, box.min.y, box.max.y);
  clip(s.o.z, s.reciprocal.z, box.min.z, box.max.z);
}
// The lanes whose rays meet a node's box where it matters.
template <class Number>
HWY_INLINE unsigned meets_box(const Search<Number>& s, const CsgNode& n) {
  Number enter = s.near, leave = min(s.far, s.best);
  clip_to(s, n.box, enter, leave);
  return bits(enter <= leave) & s.open;
}

HWY_INLINE void ask_other(const Search<Packet>& s, const CsgNode& n, const RayPacket& rays, unsigned lanes,
                          const double* from, const double* to, LaneHits& hits) {
  n.shape->intersect_packet_between({rays.rays, rays.first, lanes}, s.query.kind, from, to, hits);
}
HWY_INLINE void ask_other(const Search<PacketOf<1>>& s, const CsgNode& n, const Ray& ray, unsigned, const double* from,
                          const double* to, LaneHits& hits) {
  n.shape->intersect_between(ray, s.query.kind, *from, *to, hits.begin_lane(0));
  hits.end_lane(0);
}

// What is not computed here: the first hits of all lanes together, then the second ones and so on.
template <class Number, class Rays>
[[gnu::noinline]] void cross_other(Search<Number>& s, const CsgNode& n, const Rays& rays, unsigned lanes) {
  alignas(64) double from[Number::kCount], to[Number::kCount];
  store(from, max(s.enter, s.query.t_min)), store(to, min(s.leave, s.best));
  LaneHits hits(s.others->list());
  ask_other(s, n, rays, lanes, from, to, hits);
  each_lane(lanes, [&](int k) {
    if (hits.begin[k] == hits.end[k]) lanes &= ~(1u << k);
  });
  while (lanes != 0) {
    alignas(64) double t[Number::kCount] = {}, x[Number::kCount] = {}, y[Number::kCount] = {}, z[Number::kCount] = {};
    alignas(64) std::int64_t part[Number::kCount] = {};
    const unsigned now = lanes;
    each_lane(now, [&](int k) {
      const Hit& hit = hits.list[hits.begin[k]];
      t[k] = hit.t, x[k] = hit.point.x, y[k] = hit.point.y, z[k] = hit.point.z,
      part[k] = static_cast<std::int64_t>(hits.begin[k]);
      if (++hits.begin[k] == hits.end[k]) lanes &= ~(1u << k);
    });
    const Number at = Number::load(t);
    const typename Number::Mask valid = Number::Mask::of_bits(now);
    if (const unsigned taken = wanted(s, at, valid); taken != 0)
      consider_at(s, n, at, taken, {Number::load(x), Number::load(y), Number::load(z)}, IntsFor<Number>::load(part));
  }
}

template <class Number>
void consider_core(Search<Number>& s, const CsgNode& n, const Intersections* intersections) {
  for (int turn = 0; turn < 2; ++turn) {
    alignas(64) double t[Number::kCount] = {};
    unsigned lanes = 0;
    each_lane(s.open, [&](int k) {
      if (intersections[k].count > turn) t[k] = intersections[k].t[turn], lanes |= 1u << k;
    });
    if (lanes != 0) consider(s, n, Number::load(t), Number::Mask::of_bits(lanes), IntsFor<Number>(0));
  }
}

HWY_INLINE void cross_core(const Search<Packet>& s, const CsgNode& n, const RayPacket& rays,
                           Intersections* intersections) {
  n.convex->cross_packet({rays.rays, rays.first, s.open}, intersections);
}
HWY_INLINE void cross_core(const Search<PacketOf<1>>&, const CsgNode& n, const Ray& ray, Intersections* intersections) {
  *intersections = n.convex->cross(ray);
}
// Narrows near .. far and enter .. leave to where rays may be within the core.
template <class Number, class Rays>
[[gnu::noinline]] void narrow_to_core(Search<Number>& s, const Rays& rays, Intersections* core) {
  cross_core(s, s.tree.nodes[s.tree.core], rays, core);
  alignas(64) double enter[Number::kCount] = {}, leave[Number::kCount] = {};
  each_lane(s.open, [&](int k) { enter[k] = core[k].near, leave[k] = core[k].far; });
  s.enter = Number::load(enter), s.leave = Number::load(leave);
  s.near = max(s.near, s.enter), s.far = min(s.far, s.leave);
  s.open &= bits(s.near <= s.far);
}

HWY_INLINE unsigned admitted(const Search<Packet>& s, const RayPacket& rays) {
  return s.query.guards->admit({rays.rays, rays.first, s.open});
}
HWY_INLINE unsigned admitted(const Search<PacketOf<1>>& s, const Ray& ray) {
  return s.query.guards->admit(ray) ? s.open : 0;
}

// Leaves the lanes open that may find something.
template <class Number, class Rays>
HWY_INLINE void begin(Search<Number>& s, const Rays& rays) {
  const CsgTree& tree = s.tree;
  if (tree.bounded | tree.any_boxed) {
    constexpr double kHuge = 1e300;  // in the place of infinity, which times 0 would be NaN
    const auto reciprocal = [](const Number& v) VERISIM_INLINE_LAMBDA {
      return select(abs(v) > 1 / kHuge, Number(1.0) / v, Number(kHuge));
    };
    s.reciprocal = {reciprocal(s.d.x), reciprocal(s.d.y), reciprocal(s.d.z)};
  }
  if (tree.bounded) {
    clip_to(s, tree.limit, s.near, s.far);
    s.open &= bits(s.near <= s.far);
  }
  if (s.query.guards && s.open != 0) s.open &= admitted(s, rays);
  for (const InteriorProxy& proxy : tree.proxies)
    each_lane(s.open, [&](int k) { s.open &= proxy.holds(ray_of(s, k), s.near[k], s.far[k]) ? ~(1u << k) : ~0u; });
}

template <class Number, class Rays>
HWY_INLINE void run(Search<Number>& s, const Rays& rays) {
  const CsgTree& tree = s.tree;
  begin(s, rays);
  Intersections core[Number::kCount];
  if (tree.core != 0 && s.open != 0) narrow_to_core(s, rays, core);
  const std::uint32_t count = tree.nodes[0].end;
  for (std::uint32_t i = 1; i < count && s.open != 0;) {
    const CsgNode& n = tree.nodes[i];
    const unsigned lanes = (n.hidden >> static_cast<unsigned>(s.query.kind) & 1) != 0 ? 0
                           : n.boxed                                                  ? meets_box(s, n)
                                                                                      : s.open;
    if (lanes == 0) {
      i = n.end;
      continue;
    }
    ++i;
    switch (n.kind) {
      case CsgNode::Kind::simple:
        switch (n.simple.form) {
          case SimpleSolid::Form::plane:
            cross_plane(s, n);
            break;
          case SimpleSolid::Form::sphere:
            cross_sphere(s, n);
            break;
          case SimpleSolid::Form::box:
            cross_box(s, n);
            break;
          case SimpleSolid::Form::cone:
            cross_cone(s, n);
            break;
          default:
            cross_quadric(s, n);
            break;
        }
        break;
      case CsgNode::Kind::prism:
        cross_prism(s, n);
        break;
      case CsgNode::Kind::core:
        consider_core(s, n, core);
        break;
      case CsgNode::Kind::other:
        cross_other(s, n, rays, lanes);
        break;
      default:
        break;
    }
  }
}

template <class Number>
void take(const Search<Number>& s, Hit* hits) {
  alignas(64) double t[Number::kCount], x[Number::kCount], y[Number::kCount], z[Number::kCount];
  alignas(64) std::int64_t node[Number::kCount], part[Number::kCount];
  store(t, s.best), store(x, s.point.x), store(y, s.point.y), store(z, s.point.z), store(node, s.node),
      store(part, s.part);
  each_lane(s.found, [&](int k) {
    const CsgNode& n = s.tree.nodes[static_cast<std::size_t>(node[k])];
    if (n.kind == CsgNode::Kind::other)
      hits[k] = (*s.others)[static_cast<std::size_t>(part[k])];
    else
      hits[k] = {t[k], {x[k], y[k], z[k]}, n.shape, static_cast<std::int32_t>(part[k]), 0, 0};
  });
}

template <class Number, class Rays>
HWY_INLINE unsigned search(Search<Number>& s, const Rays& rays, Hit* hits) {
  if (s.tree.any_other) {
    ScratchHits others;  // the thread's list: looked up only where it is needed
    s.others = &others;
    run(s, rays);
    if (hits) take(s, hits);
  } else {
    run(s, rays);
    if (hits) take(s, hits);
  }
  return s.found;
}

// `hits`: null, if any hit will do.
unsigned eight(const CsgTree& tree, const RayPacket& rays, const CsgQuery& query, Hit* hits) {
  const auto place = [&](const RayBatch::Vectors& v) VERISIM_INLINE_LAMBDA {
    return PacketVector<Packet>{load(v.x + rays.first), load(v.y + rays.first), load(v.z + rays.first)};
  };
  Search<Packet> s(tree, query, place(rays.rays.origin), place(rays.rays.direction), rays.active, hits == nullptr);
  return search(s, rays, hits);
}
bool one(const CsgTree& tree, const Ray& ray, const CsgQuery& query, Hit* hit) {
  const auto place = [](const Vec3& v) { return PacketVector<PacketOf<1>>{v.x, v.y, v.z}; };
  Search<PacketOf<1>> s(tree, query, place(ray.origin), place(ray.direction), 1, hit == nullptr);
  return search(s, ray, hit) != 0;
}

const CsgKernels kKernels = {eight, one};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(CsgKernels, csg_kernels)
}  // namespace verisim::shapes
#endif
