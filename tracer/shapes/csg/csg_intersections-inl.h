// Where rays cross the simple solids of a CSG tree, and which of those hits survive. `Number` is a packet of the rays
// that go together: Packet, or PacketOf<1>.
// Included once for each target by kernels.
#if defined(VERISIM_SHAPES_CSG_CSG_CROSSINGS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_SHAPES_CSG_CSG_CROSSINGS_INL_H
#undef VERISIM_SHAPES_CSG_CSG_CROSSINGS_INL_H
#else
#define VERISIM_SHAPES_CSG_CSG_CROSSINGS_INL_H
#endif

#include "tracer/shapes/csg/csg_inside-inl.h"
#include "tracer/shapes/local_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/swept/prism_wall.inc"

template <class Number>
struct Search {
  const CsgTree& tree;
  const CsgQuery& query;
  const PacketVector<Number> o, d;
  const Number t_max;
  Number best;
  Number near, far;     // where its ray is within the object's box
  Number enter, leave;  // where it may be within the core
  PacketVector<Number> reciprocal;
  unsigned open;  // lanes that are still looked at
  const bool any;
  unsigned found = 0;
  // Of the best hits.
  PacketVector<Number> point;
  IntsFor<Number> node, part;
  ScratchHits* others = nullptr;  // hits of what is not computed here

  HWY_INLINE Search(const CsgTree& t, const CsgQuery& q, const PacketVector<Number>& origin,
                    const PacketVector<Number>& direction, unsigned lanes, bool any_hit)
      : tree(t),
        query(q),
        o(origin),
        d(direction),
        t_max(Number::load(q.t_max)),
        best(t_max),
        near(q.t_min),
        far(t_max),
        enter(-HUGE_VAL),
        leave(HUGE_VAL),
        open(lanes),
        any(any_hit) {}
};

// The lanes whose best hits so far are of the same node and as far away.
template <class Number>
HWY_INLINE unsigned own_ties(const Search<Number>& s, const CsgNode& n, const Number& t, unsigned lanes) {
  unsigned ties = ~bits(t < s.best) & lanes & s.found;
  if (ties == 0) return 0;
  alignas(64) std::int64_t node[Number::kCount];
  store(node, s.node);
  each_lane(ties, [&](int k) {
    if (node[k] != &n - s.tree.nodes.data()) ties &= ~(1u << k);
  });
  return ties;
}

// Takes hits of `lanes` at t that survive.
template <class Number>
HWY_INLINE void take_surviving(Search<Number>& s, const CsgNode& n, const Number& t, unsigned lanes,
                               const PacketVector<Number>& p, const IntsFor<Number>& part) {
  if (n.turned) lanes &= ~own_ties(s, n, t, lanes);
  for (std::uint32_t i = 0; i < n.test_count; ++i) {
    const CsgTest& test = s.tree.tests[n.tests + i];
    if ((test.hidden >> static_cast<unsigned>(s.query.kind) & 1) != 0) continue;
    const CsgNode& other = s.tree.nodes[test.node];
    const unsigned within = other.plain ? inside_simple(other, p) : inside(s.tree, other, lanes, p);
    lanes &= test.inside ? within : ~within;
    if (lanes == 0) return;
  }
  if (s.query.clipped()) [[unlikely]] {
    each_lane(lanes, [&](int k) { lanes &= s.query.within_clips(lane_of(p, k)) ? ~0u : ~(1u << k); });
    if (lanes == 0) return;
  }
  s.found |= lanes;
  if (s.any) {
    s.open &= ~lanes;
    return;
  }
  const typename Number::Mask here = Number::Mask::of_bits(lanes);
  s.best = select(here, t, s.best);
  s.point = select(here, p, s.point);
  s.node = select(here, IntsFor<Number>(&n - s.tree.nodes.data()), s.node);
  s.part = select(here, part, s.part);
}
// The lanes of `valid` whose hits at t would be the nearest.
template <class Number>
HWY_INLINE unsigned wanted(const Search<Number>& s, const Number& t, const typename Number::Mask& valid) {
  return bits(valid & (t >= s.query.t_min) & (t < s.t_max) & (t <= s.best) & (t >= s.enter) & (t <= s.leave)) & s.open;
}
// Hits that have points of their own.
template <class Number>
[[gnu::noinline]] void consider_at(Search<Number>& s, const CsgNode& n, const Number& t, unsigned lanes,
                                   const PacketVector<Number>& p, const IntsFor<Number>& part) {
  take_surviving(s, n, t, lanes, p, part);
}
// Hits that lie on the ray.
template <class Number>
[[gnu::noinline]] void consider_on_ray(Search<Number>& s, const CsgNode& n, const Number& t, unsigned lanes,
                                       const IntsFor<Number>& part) {
  take_surviving(s, n, t, lanes, point_at(s.o, t, s.d), part);
}
template <class Number>
HWY_INLINE void consider(Search<Number>& s, const CsgNode& n, const Number& t, const typename Number::Mask& valid,
                         const IntsFor<Number>& part) {
  if (const unsigned lanes = wanted(s, t, valid); lanes != 0) consider_on_ray(s, n, t, lanes, part);
}

// Takes intersections of the solid of a node at distances of the world, `scale` times as far in its own space.
template <class Number>
struct OnRay {
  using Part = IntsFor<Number>;
  Search<Number>& s;
  const CsgNode& n;
  const Number* scale;  // null: 1

  HWY_INLINE bool any(const typename Number::Mask& where) const { return (bits(where) & s.open) != 0; }
  HWY_INLINE bool operator()(const Number& t, const typename Number::Mask& where, const Part& part) const {
    if (!scale)
      consider(s, n, t, where, part);
    else if (any(where))
      consider(s, n, t / *scale, where, part);
    return false;
  }
};

// A ray in a node's own space, its direction as long as that makes it. Not copied where there is no matrix
// (inside_simple).
template <class Number>
struct NodeRay {
  PacketVector<Number> moved_o, moved_d;
  const PacketVector<Number>&o, &d;

  HWY_INLINE NodeRay(const Search<Number>& s, const CsgNode& n)
      : o(n.simple.matrix ? moved_o : s.o), d(n.simple.matrix ? moved_d : s.d) {
    if (const Transform* m = n.simple.matrix)
      moved_o = transform_point(m->inv, s.o), moved_d = transform_direction(m->inv, s.d);
  }
};

template <class Number>
void cross_plane(Search<Number>& s, const CsgNode& n) {
  const SimpleSolid& p = n.simple;
  const NodeRay<Number> ray(s, n);
  Number slope, t;
  const typename Number::Mask met = plane_intersection(p.a, p.c, ray.o, ray.d, slope, t);
  consider(s, n, t, met, IntsFor<Number>(0));
}

// The points of balls with a matrix come back from their own space.
template <class Number>
struct OnTransformedBall {
  using Part = IntsFor<Number>;
  Search<Number>& s;
  const CsgNode& n;
  const LocalRays<Number>& l;

  HWY_INLINE bool any(const typename Number::Mask& where) const { return (bits(where) & s.open) != 0; }
  HWY_INLINE bool operator()(const Number& t, const typename Number::Mask& where, const Part& part) const {
    const Number depth = t / l.scale;
    if (const unsigned lanes = wanted(s, depth, where); lanes != 0)
      consider_at(s, n, depth, lanes, transform_point(n.simple.matrix->m, point_at(l.o, t, l.d)), part);
    return false;
  }
};
template <class Number>
void cross_sphere(Search<Number>& s, const CsgNode& n) {
  const SimpleSolid& ball = n.simple;
  if (!ball.matrix) return sphere_intersections(s.o, s.d, ball.a, ball.c, OnRay<Number>{s, n, nullptr});
  const LocalRays<Number> l = local_rays(ball.matrix, s.o, s.d);
  sphere_intersections(l.o, l.d, ball.a, ball.c, OnTransformedBall<Number>{s, n, l});
}

template <class Number>
void cross_cone(Search<Number>& s, const CsgNode& n) {
  const SimpleSolid& cone = n.simple;
  const LocalRays<Number> l = local_rays(cone.matrix, s.o, s.d);
  cone_intersections(l.o, l.d, cone.cylinder, cone.open, cone.c, OnRay<Number>{s, n, &l.scale});
}

template <class Number>
void cross_quadric(Search<Number>& s, const CsgNode& n) {
  quadric_intersections(s.o, s.d, *n.simple.quadric, OnRay<Number>{s, n, nullptr});
}

template <class Number>
void cross_box(Search<Number>& s, const CsgNode& n) {
  const SimpleSolid& b = n.simple;
  const NodeRay<Number> ray(s, n);
  box_intersections(ray.o, ray.d, b.a, b.b, b.turned, OnRay<Number>{s, n, nullptr});
}

// Rays of a prism's own space that surely meet none of its surfaces: between the planes of its caps they stay on one
// side of the box of its outline, or those lie behind them. Rays in the box of a plate that stands aslant often pass it
// so. What rounding could decide is left to the walls.
template <class Number>
HWY_INLINE typename Number::Mask passes_beside(const StraightPrism::Walls& prism, const PacketVector<Number>& o,
                                               const PacketVector<Number>& d) {
  const Rectangle& box = prism.outline;
  const Number inverse = Number(1.0) / d.y, low = (Number(prism.low) - o.y) * inverse,
               high = (Number(prism.high) - o.y) * inverse;
  const Number x0 = o.x + low * d.x, x1 = o.x + high * d.x, z0 = o.z + low * d.z, z1 = o.z + high * d.z;
  const Number margin = 1e-9 * (abs(o.x) + abs(o.y) + abs(o.z) + prism.size);
  const typename Number::Mask precise = (abs(d.y) > 1e-4 * (abs(d.x) + abs(d.z))) & (abs(o.y) < 1e8 * abs(d.y));
  return precise & ((max(low, high) < 0) | (max(x0, x1) < box.min.x - margin) | (min(x0, x1) > box.max.x + margin) |
                    (max(z0, z1) < box.min.y - margin) | (min(z0, z1) > box.max.y + margin));
}

// Walls are met at distances of the world.
template <class Number>
struct OnWall {
  using Part = IntsFor<Number>;
  Search<Number>& s;
  const CsgNode& n;
  const Number& scale;

  HWY_INLINE bool any(const typename Number::Mask& where) const { return (bits(where) & s.open) != 0; }
  HWY_INLINE void operator()(const Number& t, const typename Number::Mask& where, const Part& part) const {
    if (!any(where)) return;
    const Number depth = t / scale;
    consider(s, n, depth, where & within_reach(depth), part);
  }
};
template <class Number>
void cross_prism(Search<Number>& s, const CsgNode& n) {
  constexpr std::int64_t kCap = -1;
  const StraightPrism::Walls& prism = *n.walls;
  // As Primitive::unit_local.
  PacketVector<Number> o = s.o, d = s.d;
  if (prism.matrix) o = transform_point(prism.matrix->inv, o), d = transform_direction(prism.matrix->inv, d);
  if ((s.open & ~bits(passes_beside(prism, o, d))) == 0) return;
  const Number scale = sqrt(d.x * d.x + d.y * d.y + d.z * d.z), inverse = Number(1.0) / scale;
  d = {d.x * inverse, d.y * inverse, d.z * inverse};
  const typename Number::Mask sloping = abs(d.y) > kEpsilon;
  for (const double end : {prism.low, prism.high}) {
    if (prism.open) break;
    const Number t = (Number(end) - o.y) / d.y, x = o.x + t * d.x, z = o.z + t * d.z;
    // A quotient is dear, and most rays pass a cap beside the outline, or a wall above or below it.
    const typename Number::Mask near = sloping & (x >= prism.outline.min.x) & (x <= prism.outline.max.x) &
                                       (z >= prism.outline.min.y) & (z <= prism.outline.max.y);
    if ((bits(near) & s.open) == 0) continue;
    const Number depth = t / scale;
    if (unsigned lanes = wanted(s, depth, near & within_reach(t) & within_reach(depth)); lanes != 0) {
      lanes = covered(n, lanes, x, z);
      if (lanes != 0) consider_on_ray(s, n, depth, lanes, IntsFor<Number>(kCap));
    }
  }
  const typename Number::Mask level = sloping | ((o.y >= prism.low) & (o.y <= prism.high));
  std::int64_t part = 0;
  for (const BoundedSegment& segment : prism.segments)
    wall_intersection(o, d, segment, prism.low, prism.high, level, IntsFor<Number>(part++),
                      OnWall<Number>{s, n, scale});
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#endif
