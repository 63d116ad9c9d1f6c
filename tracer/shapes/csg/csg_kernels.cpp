#include "tracer/shapes/csg/csg_tree.h"
#include <algorithm>
#include <cmath>
#include "tracer/bvh/bvh.h"
#include "tracer/shapes/quadrics/plane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/csg/csg_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/math/packet_vector-inl.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

// `Number` is a packet of the rays that go together: Packet, or PacketOf<1>.

using namespace simd::HWY_NAMESPACE;

template <class Number>
HWY_INLINE Vec3 lane_of(const PacketVector<Number>& p, int k) {
  return {p.x[k], p.y[k], p.z[k]};
}

// A point in a node's own space.
template <class Number>
HWY_INLINE PacketVector<Number> local_point(const CsgNode& n, const PacketVector<Number>& p) {
  return n.simple.matrix ? transform_point(n.simple.matrix->inv, p) : p;
}

// As the shapes' `formula`.
template <class Number>
unsigned inside_simple(const CsgNode& n, const PacketVector<Number>& at) {
  const SimpleSolid& s = n.simple;
  const PacketVector<Number> p = local_point(n, at);
  const unsigned turned = s.inverted ? (1u << Number::kCount) - 1 : 0;
  switch (s.form) {
    case SimpleSolid::Form::plane:
      return bits(p.x * s.a.x + p.y * s.a.y + p.z * s.a.z - s.c < kEpsilon) ^ turned;
    case SimpleSolid::Form::sphere: {
      const PacketVector<Number> d{p.x - s.a.x, p.y - s.a.y, p.z - s.a.z};
      const Number distance2 = dot(d, d);
      return bits(s.inverted ? distance2 > s.c : distance2 < s.c);
    }
    case SimpleSolid::Form::box:
      return bits((p.x >= s.a.x) & (p.x <= s.b.x) & (p.y >= s.a.y) & (p.y <= s.b.y) & (p.z >= s.a.z) & (p.z <= s.b.z)) ^
             turned;
    case SimpleSolid::Form::cone: {
      const double e = s.open ? kEpsilon : -kEpsilon;
      const Number limit2 = s.cylinder ? Number(1) : p.z * p.z;
      return bits((p.x * p.x + p.y * p.y <= limit2 + e) & (p.z >= s.c - e) & (p.z <= 1 + e)) ^ turned;
    }
    default: {
      const Vec3 &q = s.quadric->square, &m = s.quadric->mixed, &l = s.quadric->linear;
      return bits(p.x * (q.x * p.x + m.x * p.y + m.y * p.z + l.x) + p.y * (q.y * p.y + m.z * p.z + l.y) +
                      p.z * (q.z * p.z + l.z) + s.quadric->constant <=
                  0);
    }
  }
}

// Of `lanes`, those whose points are within a prism's outline. As Prism::covers.
template <class Number>
unsigned covered(const CsgNode& n, unsigned lanes, const Number& x, const Number& z) {
  const Rectangle& r = n.walls->outline;
  lanes &= bits((x <= r.max.x) & (x >= r.min.x) & (z >= r.min.y) & (z <= r.max.y));
  unsigned odd = 0, unsure = 0;
  for (const StraightSegment& w : n.walls->segments) {
    const typename Number::Mask level = (z >= w.z_low) & (z <= w.z_high) & (x <= w.x_high);
    const unsigned met = bits(level) & lanes, right = w.z_low != w.z_high ? met & bits(x < w.x_low) : 0;
    odd ^= right, unsure |= met & ~right;
  }
  each_lane(unsure, [&](int k) {
    const unsigned bit = 1u << k;
    odd = n.prism->covers(x[k], z[k]) ? odd | bit : odd & ~bit;
  });
  return odd;
}

template <class Number>
unsigned inside_prism(const CsgNode& n, unsigned lanes, const PacketVector<Number>& at) {
  const StraightPrism::Walls& w = *n.walls;
  const PacketVector<Number> p = w.matrix ? transform_point(w.matrix->inv, at) : at;
  const unsigned level = bits((p.y >= w.low) & (p.y < w.high)) & lanes;
  const unsigned within = level != 0 ? covered(n, level, p.x, p.z) : 0;
  return w.inverted ? lanes & ~within : within;
}

template <class Number>
unsigned inside_parts(const CsgTree& tree, const CsgNode& n, unsigned lanes, const PacketVector<Number>& p);

// Of `lanes`, those whose points are inside a node.
template <class Number>
unsigned inside(const CsgTree& tree, const CsgNode& n, unsigned lanes, const PacketVector<Number>& p) {
  if (n.boxed_solid) {
    const unsigned here = bits((p.x >= n.solid.min.x) & (p.x <= n.solid.max.x) & (p.y >= n.solid.min.y) &
                               (p.y <= n.solid.max.y) & (p.z >= n.solid.min.z) & (p.z <= n.solid.max.z)) &
                          lanes;
    const unsigned beyond = n.far_is_inside ? lanes & ~here : 0;
    return here == 0 ? beyond : beyond | inside_parts(tree, n, here, p);
  }
  return inside_parts(tree, n, lanes, p);
}
template <class Number>
unsigned inside_parts(const CsgTree& tree, const CsgNode& n, unsigned lanes, const PacketVector<Number>& p) {
  switch (n.kind) {
    case CsgNode::Kind::simple:
      return inside_simple(n, p) & lanes;
    case CsgNode::Kind::prism:
      return inside_prism(n, lanes, p);
    case CsgNode::Kind::intersection:
      for (std::uint32_t i = 0; i < n.child_count && lanes != 0; ++i)
        lanes = inside(tree, tree.nodes[tree.children[n.children + i]], lanes, p);
      return lanes;
    case CsgNode::Kind::sum: {
      unsigned found = 0;
      for (std::uint32_t i = 0; i < n.child_count && lanes != found; ++i)
        found |= inside(tree, tree.nodes[tree.children[n.children + i]], lanes & ~found, p);
      return found;
    }
    default: {
      unsigned found = 0;
      each_lane(lanes, [&](int k) {
        const Vec3 at = lane_of(p, k);
        found |= n.shape->inside(at) ? 1u << k : 0;
      });
      return found;
    }
  }
}

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

// Takes hits of `lanes` at t that survive.
template <class Number>
HWY_INLINE void take_surviving(Search<Number>& s, const CsgNode& n, const Number& t, unsigned lanes,
                               const PacketVector<Number>& p, const IntsFor<Number>& part) {
  for (std::uint32_t i = 0; i < n.test_count; ++i) {
    const CsgTest& test = s.tree.tests[n.tests + i];
    if ((test.hidden >> static_cast<unsigned>(s.query.kind) & 1) != 0) continue;
    const CsgNode& other = s.tree.nodes[test.node];
    const unsigned within =
        other.kind == CsgNode::Kind::simple ? inside_simple(other, p) : inside(s.tree, other, lanes, p);
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

template <class Number>
struct LocalRayOf {
  PacketVector<Number> o, d;
  Number scale;
};
// As Primitive::local.
template <class Number>
HWY_INLINE LocalRayOf<Number> local_ray(const Search<Number>& s, const CsgNode& n) {
  if (!n.simple.matrix) return {s.o, s.d, Number(1)};
  PacketVector<Number> d = transform_direction(n.simple.matrix->inv, s.d);
  const Number scale = sqrt(d.x * d.x + d.y * d.y + d.z * d.z), inverse = Number(1.0) / scale;
  return {transform_point(n.simple.matrix->inv, s.o), {d.x * inverse, d.y * inverse, d.z * inverse}, scale};
}

template <class Number>
void cross_plane(Search<Number>& s, const CsgNode& n) {
  const SimpleSolid& p = n.simple;
  const PacketVector<Number> o = local_point(n, s.o),
                             d = p.matrix ? transform_direction(n.simple.matrix->inv, s.d) : s.d;
  const Number slope = p.a.x * d.x + p.a.y * d.y + p.a.z * d.z,
               t = (Number(p.c) - (p.a.x * o.x + p.a.y * o.y + p.a.z * o.z)) / slope;
  consider(s, n, t, ~(abs(slope) < kEpsilon) & (t >= kNearestPlane) & (t <= kFarthestPlane), IntsFor<Number>(0));
}

template <class Number>
void cross_sphere(Search<Number>& s, const CsgNode& n) {
  constexpr double kNearest = 1e-6, kFarthest = 1e7;
  const SimpleSolid& ball = n.simple;
  const LocalRayOf<Number> l = local_ray(s, n);
  const PacketVector<Number> to_center{Number(ball.a.x) - l.o.x, Number(ball.a.y) - l.o.y, Number(ball.a.z) - l.o.z};
  const Number distance_squared = dot(to_center, to_center), closest = dot(to_center, l.d);
  const Number half_chord2 = Number(ball.c) - distance_squared + closest * closest;
  const typename Number::Mask crosses =
      ~((distance_squared >= ball.c) & (closest < kEpsilon)) & (half_chord2 > kEpsilon);
  if ((bits(crosses) & s.open) == 0) return;
  const Number half_chord = sqrt(half_chord2);
  const auto report = [&](const Number& t) VERISIM_INLINE_LAMBDA {
    const typename Number::Mask valid = crosses & (t > kNearest) & (t < kFarthest);
    if (!ball.matrix) return consider(s, n, t, valid, IntsFor<Number>(0));
    const Number depth = t / l.scale;
    if (const unsigned lanes = wanted(s, depth, valid); lanes != 0)
      consider_at(s, n, depth, lanes, transform_point(n.simple.matrix->m, point_at(l.o, t, l.d)), IntsFor<Number>(0));
  };
  report(closest - half_chord);
  report(closest + half_chord);
}

template <class Number>
void cross_cone(Search<Number>& s, const CsgNode& n) {
  constexpr double kNearest = 1e-9, kFarthest = 1e7;
  enum : std::int64_t { wall, narrow_cap, wide_cap };
  const bool cylinder = n.simple.cylinder;
  const double narrow = n.simple.c;
  const LocalRayOf<Number> l = local_ray(s, n);
  const PacketVector<Number>&o = l.o, &d = l.d;
  const auto report = [&](const Number& t, const typename Number::Mask& valid, std::int64_t part)
                          VERISIM_INLINE_LAMBDA {
                            const typename Number::Mask here = valid & (t > kNearest) & (t < kFarthest);
                            if ((bits(here) & s.open) != 0) consider(s, n, t / l.scale, here, IntsFor<Number>(part));
                          };
  const auto report_wall = [&](const Number& t, const typename Number::Mask& valid) VERISIM_INLINE_LAMBDA {
    const Number z = o.z + t * d.z;
    report(t, valid & (z >= narrow) & (z <= Number(1)), wall);
  };
  if (cylinder) {
    const Number a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, c = o.x * o.x + o.y * o.y - 1;
    const Number discriminant = b * b - a * c;
    const typename Number::Mask curved = a > kEpsilon, real = curved & (discriminant >= 0);
    if ((bits(real) & s.open) != 0) {
      const Number root = sqrt(discriminant);
      report_wall((-b + root) / a, real);
      report_wall((-b - root) / a, real);
    }
  } else {
    const Number a = d.x * d.x + d.y * d.y - d.z * d.z, b = o.x * d.x + o.y * d.y - o.z * d.z,
                 c = o.x * o.x + o.y * o.y - o.z * o.z;
    const Number discriminant = b * b - a * c;
    const typename Number::Mask linear = abs(a) < kEpsilon, real = ~linear & (discriminant >= 0),
                                sloped = linear & (abs(b) > kEpsilon);
    if ((bits(real | sloped) & s.open) != 0) {
      if ((bits(sloped) & s.open) != 0) report_wall(-0.5 * c / b, sloped);
      if ((bits(real) & s.open) != 0) {
        const Number root = sqrt(discriminant);
        report_wall((-b - root) / a, real);
        report_wall((-b + root) / a, real);
      }
    }
  }
  if (n.simple.open) return;
  const typename Number::Mask sloping = abs(d.z) > kEpsilon;
  const auto report_cap = [&](double end, double radius2, std::int64_t part) VERISIM_INLINE_LAMBDA {
    const Number t = (Number(end) - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    report(t, sloping & (x * x + y * y <= radius2), part);
  };
  report_cap(1, 1, wide_cap);
  report_cap(narrow, cylinder ? 1 : narrow * narrow, narrow_cap);
}

template <class Number>
void cross_quadric(Search<Number>& s, const CsgNode& n) {
  constexpr double kNearest = 1e-6, kFarthest = 1e7;
  const scene::Quadric& surface = *n.simple.quadric;
  const Vec3 &q = surface.square, &m = surface.mixed, &l = surface.linear;
  const PacketVector<Number>&o = s.o, &d = s.d;
  const Number a = d.x * (q.x * d.x + m.x * d.y + m.y * d.z) + d.y * (q.y * d.y + m.z * d.z) + d.z * q.z * d.z;
  const Number b = d.x * (q.x * o.x + 0.5 * (m.x * o.y + m.y * o.z + l.x)) +
                   d.y * (q.y * o.y + 0.5 * (m.x * o.x + m.z * o.z + l.y)) +
                   d.z * (q.z * o.z + 0.5 * (m.y * o.x + m.z * o.y + l.z));
  const Number c = o.x * (q.x * o.x + m.x * o.y + m.y * o.z + l.x) + o.y * (q.y * o.y + m.z * o.z + l.y) +
                   o.z * (q.z * o.z + l.z) + surface.constant;
  const Number discriminant = b * b - a * c;
  const typename Number::Mask curved = a != 0, real = curved & (discriminant > 0), straight = ~curved & (b != 0);
  const auto report = [&](const Number& t, const typename Number::Mask& valid) VERISIM_INLINE_LAMBDA {
    consider(s, n, t, valid & (t > kNearest) & (t < kFarthest), IntsFor<Number>(0));
  };
  if ((bits(real) & s.open) != 0) {
    const Number root = sqrt(discriminant);
    report((-b + root) / a, real);
    report((-b - root) / a, real);
  }
  if ((bits(straight) & s.open) != 0) [[unlikely]]
    report(-0.5 * c / b, straight);
}

template <class Number>
void cross_prism(Search<Number>& s, const CsgNode& n) {
  constexpr std::int64_t kCap = -1;
  const StraightPrism::Walls& prism = *n.walls;
  // As Primitive::unit_local.
  PacketVector<Number> o = s.o, d = s.d;
  if (prism.matrix) o = transform_point(prism.matrix->inv, o), d = transform_direction(prism.matrix->inv, d);
  const Number scale = sqrt(d.x * d.x + d.y * d.y + d.z * d.z), inverse = Number(1.0) / scale;
  d = {d.x * inverse, d.y * inverse, d.z * inverse};
  const auto reach = [&](const Number& depth) VERISIM_INLINE_LAMBDA {
    return (depth > StraightPrism::kNearest) & (depth < StraightPrism::kFarthest);
  };
  const typename Number::Mask sloping = abs(d.y) > kEpsilon;
  for (const double end : {prism.low, prism.high}) {
    if (prism.open) break;
    const Number t = (Number(end) - o.y) / d.y, depth = t / scale;
    if (unsigned lanes = wanted(s, depth, sloping & reach(depth)); lanes != 0) {
      lanes = covered(n, lanes, o.x + t * d.x, o.z + t * d.z);
      if (lanes != 0) consider_on_ray(s, n, depth, lanes, IntsFor<Number>(kCap));
    }
  }
  const typename Number::Mask level = sloping | ((o.y >= prism.low) & (o.y <= prism.high)), by_x = abs(d.x) > kEpsilon;
  std::int64_t part = 0;
  for (const StraightSegment& w : prism.segments) {
    const IntsFor<Number> wall(part++);
    const Number slope = d.z * w.dx + -d.x * w.dz;
    const Number at = -(d.z * (Number(w.x) - o.x) + -d.x * (Number(w.z) - o.z)) / slope;
    const typename Number::Mask met = level & (slope != 0) & (at >= 0) & (at <= 1);
    if ((bits(met) & s.open) == 0) continue;
    const Number t = select(by_x, (w.dx * at + w.x - o.x) / d.x, (w.dz * at + w.z - o.z) / d.z), y = o.y + t * d.y,
                 depth = t / scale;
    consider(s, n, depth, met & (y >= prism.low) & (y <= prism.high) & reach(depth), wall);
  }
}

template <class Number>
struct Slabs {
  Number near, far, near_size, far_size;  // |d| along the axes of the faces
  IntsFor<Number> near_face, far_face;
  typename Number::Mask has_near, has_far, alive;
};
template <class Number>
HWY_INLINE void narrow_by_axis(const Number& o, const Number& d, double low, double high, std::int64_t low_face,
                               Slabs<Number>& s) {
  const Number size = abs(d);
  const typename Number::Mask across = size > kEpsilon, backward = d < 0;
  const Number to_low = (Number(low) - o) / d, to_high = (Number(high) - o) / d;
  const Number enter = select(backward, to_high, to_low), leave = select(backward, to_low, to_high);
  const Number near_gain = enter - s.near, far_gain = s.far - leave;
  const typename Number::Mask enters =
      across & ((near_gain > 1e-6) | (s.has_near & (near_gain > -1e-6) & (size > s.near_size)));
  const typename Number::Mask leaves =
      across & ((far_gain > 1e-6) | (s.has_far & (far_gain > -1e-6) & (size > s.far_size)));
  s.near_face = select(enters, select(backward, IntsFor<Number>(low_face + 1), IntsFor<Number>(low_face)), s.near_face);
  s.far_face = select(leaves, select(backward, IntsFor<Number>(low_face), IntsFor<Number>(low_face + 1)), s.far_face);
  s.near_size = select(enters, size, s.near_size), s.far_size = select(leaves, size, s.far_size);
  s.has_near = s.has_near | enters, s.has_far = s.has_far | leaves;
  s.near = select(across & (enter > s.near), enter, s.near), s.far = select(across & (leave < s.far), leave, s.far);
  s.alive = s.alive & select(across, ~(enter > leave) & (s.near <= s.far), (o >= low) & (o <= high));
}
template <class Number>
void cross_box(Search<Number>& s, const CsgNode& n) {
  constexpr double kNearest = 1e-6, kFarthest = 2e10;
  const SimpleSolid& b = n.simple;
  const PacketVector<Number> o = local_point(n, s.o),
                             d = b.matrix ? transform_direction(n.simple.matrix->inv, s.d) : s.d;
  const typename Number::Mask none{}, all = Number::Mask::all();
  const IntsFor<Number> no_face(-1);
  Slabs<Number> slabs{Number(0.0), Number(kFarthest), Number(0.0), Number(0.0), no_face, no_face, none, none, all};
  narrow_by_axis(o.x, d.x, b.a.x, b.b.x, 0, slabs);
  narrow_by_axis(o.y, d.y, b.a.y, b.b.y, 2, slabs);
  if ((bits(slabs.alive) & s.open) == 0) return;
  narrow_by_axis(o.z, d.z, b.a.z, b.b.z, 4, slabs);
  const typename Number::Mask met = slabs.alive & ~(slabs.far < kNearest);
  if ((bits(met) & s.open) == 0) return;
  consider(s, n, slabs.near, met & slabs.has_near & (slabs.near > kNearest), slabs.near_face);
  consider(s, n, slabs.far, met & slabs.has_far, slabs.far_face);
}

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

// What is not computed here: the first hits of all lanes together, then the second ones and so on.
template <class Number>
[[gnu::noinline]] void cross_other(Search<Number>& s, const CsgNode& n, unsigned lanes) {
  std::size_t begin[Number::kCount], end[Number::kCount];
  alignas(64) double from[Number::kCount], to[Number::kCount];
  const bool within_core = s.tree.true_distances;
  store(from, within_core ? max(s.enter, s.query.t_min) : Number(s.query.t_min)),
      store(to, within_core ? min(s.leave, s.best) : s.best);
  each_lane(lanes, [&](int k) {
    begin[k] = s.others->end();
    n.shape->intersect_between(ray_of(s, k), s.query.kind, from[k], to[k], s.others->list());
    end[k] = s.others->end();
    if (begin[k] == end[k]) lanes &= ~(1u << k);
  });
  while (lanes != 0) {
    alignas(64) double t[Number::kCount] = {}, x[Number::kCount] = {}, y[Number::kCount] = {}, z[Number::kCount] = {};
    alignas(64) std::int64_t part[Number::kCount] = {};
    const unsigned now = lanes;
    each_lane(now, [&](int k) {
      const Hit& hit = (*s.others)[begin[k]];
      t[k] = hit.t, x[k] = hit.point.x, y[k] = hit.point.y, z[k] = hit.point.z,
      part[k] = static_cast<std::int64_t>(begin[k]);
      if (++begin[k] == end[k]) lanes &= ~(1u << k);
    });
    const Number at = Number::load(t);
    const typename Number::Mask valid = Number::Mask::of_bits(now);
    const unsigned taken = s.tree.true_distances
                               ? wanted(s, at, valid)
                               : bits(valid & (at >= s.query.t_min) & (at < s.t_max) & (at <= s.best)) & s.open;
    if (taken != 0)
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
        cross_other(s, n, lanes);
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
