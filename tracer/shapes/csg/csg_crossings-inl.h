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
#include "tracer/shapes/quadrics/plane.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

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
  // Of an edge the nearer face stays where the order is turned, else the farther one takes its place.
  const typename Number::Mask other = b.turned ? slabs.far > slabs.near : all;
  consider(s, n, slabs.far, met & slabs.has_far & other, slabs.far_face);
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#endif
