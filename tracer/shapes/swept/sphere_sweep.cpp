// sphere_sweep (spec 03 4.18): a sphere whose centre and radius follow a spline.
//
// The body is the union of the spheres at the joints and, per segment, of the envelope of the moving sphere closed by
// two planes. A ray crosses the envelope where |O + tD - C(u)|^2 = R(u)^2 and the derivative of that by u vanishes;
// eliminating t leaves a polynomial of degree 2 or 10 in u. All intersections are sorted, and a nesting counter keeps
// those that enter or leave the union.
//
// Coefficients, roots and depths have all of POV-Ray's bits (spec 08 F).
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tracer/bvh/bvh.h"
#include "tracer/math/bernstein_packet.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/kept_point.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/scratch.h"
#include "tracer/shapes/swept/sphere_sweep_packet.h"

namespace verisim::shapes {
namespace {

constexpr double kFarthest = 1e7;
constexpr double kAcross = 1e-4;  // of a ray across the way of the spheres
constexpr double kSixth = 1 / 6.0, kTwoThirds = 4 / 6.0;
constexpr std::size_t kFewParts = 1;

using Vec4 = Imath::V4d;  // centre and radius

struct Segment {
  std::array<Vec4, 4> c{Vec4(0), Vec4(0), Vec4(0), Vec4(0)};  // powers of u
  int degree = 1;

  // Centre and radius are summed in opposite orders.
  Vec4 at(double u) const {
    const double u2 = u * u, u3 = u2 * u;
    Vec4 sphere = c[0] + c[1] * u + c[2] * u2 + c[3] * u3;
    sphere.w = c[3].w * u * u * u + c[2].w * u * u + c[1].w * u + c[0].w;
    return sphere;
  }
  // At u = 1, summed as centres are.
  Vec4 end() const { return c[0] + c[1] + c[2] + c[3]; }
  Vec4 start_slope() const { return c[1]; }
  Vec4 end_slope() const { return c[1] + c[2] * 2.0 + c[3] * 3.0; }
};

Vec3 center_of(const Vec4& v) { return {v.x, v.y, v.z}; }

#include "tracer/shapes/swept/sphere_sweep_side.inc"

SweepCubic cubic_of(const Segment& s) {
  SweepCubic cubic;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 4; ++x) cubic.power[i][x] = s.c[static_cast<std::size_t>(i)][x];
  for (int x = 0; x < 3; ++x) cubic.middle[x] = s.at(0.5)[x];
  return cubic;
}

std::vector<Segment> segments_of(const scene::SphereSweep& sweep) {
  std::vector<Vec4> p;
  for (std::size_t i = 0; i < sweep.centers.size() && i < sweep.radii.size(); ++i) {
    const Vec3& c = sweep.centers[i];
    p.emplace_back(c.x, c.y, c.z, sweep.radii[i]);
  }
  std::vector<Segment> segments;
  const std::size_t n = p.size();
  if (sweep.spline == scene::SplineKind::linear) {
    for (std::size_t i = 0; i + 1 < n; ++i) segments.push_back({{p[i], p[i + 1] - p[i], Vec4(0), Vec4(0)}, 1});
    return segments;
  }
  for (std::size_t i = 0; i + 3 < n; ++i) {
    const Vec4 &a = p[i], &b = p[i + 1], &c = p[i + 2], &d = p[i + 3];
    if (sweep.spline == scene::SplineKind::b_spline)
      segments.push_back({{a * kSixth + b * kTwoThirds + c * kSixth, c * 0.5 - a * 0.5, a * 0.5 - b + c * 0.5,
                           b * 0.5 - a * kSixth - c * 0.5 + d * kSixth},
                          3});
    else
      segments.push_back(
          {{b, c * 0.5 - a * 0.5, a - b * 2.5 + c * 2.0 - d * 0.5, b * 1.5 - a * 0.5 - c * 1.5 + d * 0.5}, 3});
  }
  return segments;
}

// Of the spheres of a segment: of its control points in Bezier form.
Box3 box_of(const Segment& s) {
  std::array<Vec4, 4> b;
  b[0] = s.c[0];
  b[1] = s.c[0] + s.c[1] / 3.0;
  b[2] = s.c[0] + s.c[1] * (2.0 / 3.0) + s.c[2] / 3.0;
  b[3] = s.c[0] + s.c[1] + s.c[2] + s.c[3];
  double radius = 0;
  for (const Vec4& v : b) radius = std::max(radius, std::fabs(v.w));
  Box3 box;
  for (const Vec4& v : b) {
    box.extendBy(center_of(v) - Vec3(radius));
    box.extendBy(center_of(v) + Vec3(radius));
  }
  return box;
}

Box3 box_of(const std::vector<Segment>& segments) {
  Box3 box;
  for (const Segment& s : segments) box.extendBy(box_of(s));
  return box;
}

// `chord`: of a side, found as the ends of a chord through one of its spheres.
enum Part : std::int32_t { joint, side, chord, start_plane, end_plane };
constexpr std::int32_t kParts = 5;

struct Intersection {
  double t, u;
  std::int32_t segment;
  Part part;
  bool enters;
};

// Whether the precise polynomial of a side, in powers of u, may have roots in [0, 1] for POV-Ray. Where the curve lies
// across the ray it is nearly a square, and rounding decides: so what comes close to 0 counts. True: it does at an end;
// else power[0] moves by as much as that.
bool touches_at_end(double (&power)[11]) {
  constexpr double kClose = 1e-9;
  double size = 0, end = 0;
  for (const double c : power) size += std::fabs(c), end += c;
  const double close = kClose * size;
  if (!(std::fabs(power[0]) > close && std::fabs(end) > close)) return true;
  power[0] -= std::copysign(close, power[0]);
  return false;
}

// Whether the Bernstein coefficients of a polynomial on [0, 1] have both signs; leading coefficient first.
bool changes_sign(const double (&falling)[11]) {
  double b[11];
  for (int i = 0; i <= 10; ++i) b[i] = falling[10 - i] * bernstein::kBinomials.inverse[10][i];
  bernstein::sum_binomials<10>(b);
  const auto [least, most] = std::minmax_element(b, b + 11);
  return *least < 0 && *most > 0;
}

// t^2 + B(u) t + K(u) = 0 where a ray meets the sphere at u of a segment. In powers of u.
struct Spheres {
  double b[4], k[7];

  Spheres(const Segment& s, const LocalRay& l) {
    const auto& [c0, c1, c2, c3] = s.c;
    const Vec3 to = center_of(c0) - l.origin, v1 = center_of(c1), v2 = center_of(c2), v3 = center_of(c3);
    const double r0 = c0.w, r1 = c1.w, r2 = c2.w, r3 = c3.w;
    b[0] = -2 * dot(to, l.direction), b[1] = -2 * dot(v1, l.direction);
    b[2] = -2 * dot(v2, l.direction), b[3] = -2 * dot(v3, l.direction);
    k[0] = dot(to, to) - r0 * r0;
    k[1] = 2 * (dot(to, v1) - r0 * r1);
    k[2] = 2 * dot(to, v2) - 2 * r0 * r2 + dot(v1, v1) - r1 * r1;
    k[3] = 2 * dot(to, v3) + 2 * dot(v1, v2) - 2 * r0 * r3 - 2 * r1 * r2;
    k[4] = 2 * dot(v1, v3) + dot(v2, v2) - 2 * r1 * r3 - r2 * r2;
    k[5] = 2 * (dot(v2, v3) - r2 * r3);
    k[6] = dot(v3, v3) - r3 * r3;
  }

  // What is left of it and its derivative by u without t: K'^2 - B B' K' + B'^2 K, u to the n-th.
  template <int n>
  double touching() const {
    double sum = 0;
    for (int i = std::max(1, n - 4), j = n + 2 - i; i <= j; ++i, --j)
      sum += i == j ? i * i * (k[i] * k[i]) : 2 * i * j * k[j] * k[i];
    const int first = std::max(0, n - 4);
    for (int l = std::max(first, n - 1); l <= 6 && l <= n + 1; ++l) {
      const int j = n + 2 - l;
      if (l > 0) sum += -j * l * b[j] * k[l] * b[0];
    }
    for (int l = first; l <= 6 && l <= n; ++l)
      for (int i = (n + 2 - l) / 2, j = n + 2 - l - i; i > 0 && j <= 3; --i, ++j) {
        const int factor = i == j ? i * (i - l) : 2 * i * j - (i + j) * l;
        if (factor != 0) sum += i == j ? factor * k[l] * (b[i] * b[i]) : factor * b[j] * b[i] * k[l];
      }
    return sum;
  }
};

// A segment that a ray of several may meet.
struct Visit {
  std::uint32_t segment;
  int lane;
  bool solved, touched;
};

class SphereSweep final : public SearchPrimitive<SphereSweep> {
 public:
  SphereSweep(const scene::Object& description, const scene::SphereSweep& sweep)
      : SearchPrimitive(description, {box_of(segments_of(sweep))}),
        segments_(segments_of(sweep)),
        tolerance_(sweep.tolerance) {
    std::vector<Box3> boxes;
    bool finite = true;
    for (const Segment& s : segments_) {
      boxes.push_back(box_of(s));
      finite = finite && accel::is_finite(boxes.back()) && !accel::is_empty(boxes.back());
    }
    if (segments_.size() > kFewParts && finite) tree_ = accel::Bvh(boxes);
    constexpr double kAfar = 1e5;
    const Box3 box = box_of(segments_);
    if (!tree_.empty()) center_ = box.center(), far2_ = kAfar * kAfar * box.size().length2();
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    Scratch<Intersection> all;
    each_segment_met(l, [&](std::uint32_t i) { segment(i, l, may_touch(segments_[i], l), all); });
    report(l, all, sink);
  }

  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.active;
    Scratch<Visit> visits;
    std::size_t first[RayPacket::kCount], end[RayPacket::kCount];
    unsigned met = 0;
    each_lane(admitted, [&](int k) {
      first[k] = visits.size();
      const LocalRay l = local(rays.at(k));
      each_segment_met(l, [&](std::uint32_t i) { visits.add({i, k, rounding_decides(segments_[i], l), true}); });
      end[k] = visits.size();
      met |= end[k] > first[k] ? 1u << k : 0;
    });
    if (met == 0) return 0;
    LocalPacket packet;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, packet);
    for (std::size_t v = 0; v < visits.size(); ++v)
      if (!visits[v].solved) solve_together(packet, visits, v);
    unsigned found = 0;
    each_lane(met, [&](int k) {
      const LocalRay l = local(rays.at(k));
      Scratch<Intersection> all;
      for (std::size_t v = first[k]; v < end[k]; ++v) segment(visits[v].segment, l, visits[v].touched, all);
      NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
      report(l, all, sink);
      found |= sink.found() ? 1u << k : 0;
    });
    return found;
  }

  // As in POV-Ray: on the wall of some sphere of a segment, so a point inside all spheres of a short segment is missed
  // (spec 03 4.18).
  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    const auto covers = [&](std::size_t i) {
      const Segment& s = segments_[i];
      const int degree = 2 * s.degree;
      const Spheres spheres(s, {p, Vec3(0)});
      double falling[7], roots[6];
      for (int n = 0; n <= degree; ++n) falling[degree - n] = spheres.k[n];
      const int count = solve_polynomial(degree, falling, roots, true);
      return std::any_of(roots, roots + count, [](double u) { return u >= 0 && u <= 1; });
    };
    if (!tree_.empty()) return tree_.any_around(p, covers);
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (covers(i)) return true;
    return false;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Segment& s = segments_[static_cast<std::size_t>(hit.part / kParts)];
    const auto part = static_cast<Part>(hit.part % kParts);
    const Vec4 sphere = part == joint && hit.u == 1 ? s.end() : s.at(hit.u);
    Vec3 n;
    if (part == start_plane)
      n = -center_of(s.start_slope());
    else if (part == end_plane)
      n = center_of(s.end_slope());
    else
      n = found_point(hit, moved_by()) - center_of(sphere);
    // Spheres are divided by their radius, all else is normalised; what has a matrix is normalised in the world again.
    if (part == joint || part == chord)
      n *= 1 / sphere.w;
    else if (n != Vec3(0))
      n = normalize(n);
    return n == Vec3(0) ? Vec3(1, 0, 0) : has_matrix() ? world_normal(n) : n;
  }

 private:
  const Transform* moved_by() const { return has_matrix() ? &matrix() : nullptr; }
  // What lies behind the origin counts for nesting, too.
  template <class Meet>
  void each_segment_met(const LocalRay& l, Meet&& meet) const {
    if (tree_.empty() || !((l.origin - center_).length2() < far2_)) {
      for (std::uint32_t i = 0; i < segments_.size(); ++i) meet(i);
      return;
    }
    tree_.traverse({l.origin, l.direction}, -HUGE_VAL, HUGE_VAL, [&](std::uint32_t i, double limit) {
      meet(i);
      return limit;
    });
  }

  template <class Sink>
  void report(const LocalRay& l, Scratch<Intersection>& all, Sink& sink) const {
    if (all.size() == 0) return;
    all.sort([](const Intersection& a, const Intersection& b) {
      if (a.t != b.t) return a.t < b.t;
      if ((a.part == joint) != (b.part == joint)) return a.part == joint;
      return a.segment < b.segment;
    });
    const auto add = [&](const Intersection& c) {
      const double depth = c.t / l.scale;
      if (!(depth > tolerance_)) return;
      add_found(sink, depth, l.origin + c.t * l.direction, moved_by(), c.segment * kParts + c.part, c.u);
    };
    add(all[0]);
    int depth = 1;
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      const bool boundary = all[i].enters ? depth == 0 : depth == 1;
      depth += all[i].enters ? 1 : -1;
      if (boundary) add(all[i]);
    }
    if (all.size() > 1) add(all[all.size() - 1]);
  }

  // POV-Ray's polynomials have lost what tells them from 0 where a ray comes from afar, and some of the roots.
  static bool rounding_decides(const Segment& s, const LocalRay& l) {
    constexpr double kAfar = 1e3;
    if (s.degree == 1) return true;
    const Vec3 to = center_of(s.c[0]) - l.origin;
    double size = s.c[0].w * s.c[0].w;
    for (std::size_t i = 1; i < 4; ++i) size += dot(center_of(s.c[i]), center_of(s.c[i]));
    return dot(to, to) > kAfar * kAfar * size;
  }
  // Whether the side is touched, by a polynomial that is precise: POV-Ray's decides where.
  static bool may_touch(const Segment& s, const LocalRay& l) {
    if (rounding_decides(s, l)) return true;
    const double origin[3] = {l.origin.x, l.origin.y, l.origin.z},
                 direction[3] = {l.direction.x, l.direction.y, l.direction.z};
    SweepSide<double> side;
    follow(cubic_of(s), origin, direction, side);
    double root;
    return touches_at_end(side.power) || bernstein_roots<10>(side.power, 0, 1, &root, 1) > 0;
  }
  // The same for a visit and for those behind it of the same segment. Each ray has its own list of segments.
  void solve_together(const LocalPacket& rays, Scratch<Visit>& visits, std::size_t begin) const {
    const std::uint32_t index = visits[begin].segment;
    const Segment& s = segments_[index];
    SweepSidePacket side;
    sweep_follow()(cubic_of(s), rays, side);
    RootPacket roots;
    unsigned wanted = 0;
    Visit* of_lane[RayPacket::kCount];
    for (std::size_t v = begin; v < visits.size(); ++v) {
      Visit& visit = visits[v];
      if (visit.segment != index) continue;
      const int k = visit.lane;
      double power[11];
      for (int i = 0; i <= 10; ++i) power[i] = side.power[i][k];
      visit.solved = true, visit.touched = touches_at_end(power);
      if (visit.touched) continue;
      of_lane[k] = &visit;
      for (int i = 0; i <= 10; ++i) roots.power[i][k] = power[i];
      roots.from[k] = 0, roots.to[k] = 1;
      wanted |= 1u << k;
    }
    if (wanted == 0) return;
    const unsigned open = bernstein_kernels().begin(10, wanted, roots);
    if (open != 0) each_lane(bernstein_kernels().next(10, open, roots), [&](int k) { of_lane[k]->touched = true; });
  }

  // `touched`: its side.
  void segment(std::size_t i, const LocalRay& l, bool touched, Scratch<Intersection>& all) const {
    const Segment& s = segments_[i];
    const auto index = static_cast<std::int32_t>(i);
    joint_sphere(s.c[0], 0, index, l, all);
    if (i + 1 == segments_.size()) joint_sphere(s.end(), 1, index, l, all);
    plane(s.c[0], s.start_slope(), start_plane, index, l, all);
    plane(s.end(), s.end_slope(), end_plane, index, l, all);
    if (s.degree == 1)
      linear_side(s, index, l, all);
    else if (touched)
      curved_side(s, index, l, all);
  }

  // False, too: none of it is before the origin.
  static bool sphere_chord(const Vec4& sphere, const LocalRay& l, double& near, double& far) {
    const Vec3 to = center_of(sphere) - l.origin;
    const double closest = dot(to, l.direction), half2 = sphere.w * sphere.w - dot(to, to) + closest * closest;
    if (!(half2 > kEpsilon)) return false;
    const double half = std::sqrt(half2);
    near = closest - half, far = closest + half;
    return far > 0;
  }

  // Normals point inwards where the radius is negative.
  static void add_chord(double near, double far, double u, std::int32_t index, Part part, double radius,
                        Scratch<Intersection>& all) {
    all.add({near, u, index, part, radius > 0});
    all.add({far, u, index, part, !(radius > 0)});
  }

  static void joint_sphere(const Vec4& sphere, double u, std::int32_t index, const LocalRay& l,
                           Scratch<Intersection>& all) {
    double near, far;
    if (!sphere_chord(sphere, l, near, far) || !(near < kFarthest)) return;
    add_chord(near, far, u, index, joint, sphere.w, all);
  }

  // C'(u).(P - C(u)) + R R' = 0 within the sphere at that end of a segment.
  static void plane(const Vec4& sphere, const Vec4& slope, Part end, std::int32_t index, const LocalRay& l,
                    Scratch<Intersection>& all) {
    const Vec3 n = center_of(slope), c = center_of(sphere);
    const double along = dot(n, l.direction);
    if (std::fabs(along) < kEpsilon) return;
    const double t = -(dot(n, l.origin - c) + sphere.w * slope.w) / along;
    const Vec3 from = l.origin + t * l.direction - c;
    if (!(dot(from, from) < sphere.w * sphere.w) || !(std::fabs(t) < kFarthest)) return;
    all.add({t, end == start_plane ? 0.0 : 1.0, index, end, (end == start_plane) == (along > 0)});
  }

  static void add_side(const Segment& s, double u, double t, std::int32_t index, Part part, const LocalRay& l,
                       Scratch<Intersection>& all) {
    if (!(std::fabs(t) < kFarthest)) return;
    const Vec3 n = l.origin + t * l.direction - center_of(s.at(u));
    all.add({t, u, index, part, dot(n, l.direction) < 0});
  }

  void linear_side(const Segment& s, std::int32_t index, const LocalRay& l, Scratch<Intersection>& all) const {
    // t^2 + (e + u d) t + a u^2 + b u + c, whose derivative by u vanishes at t = -(2 a u + b) / d.
    const Vec3 way = center_of(s.c[1]), to = center_of(s.c[0]) - l.origin;
    const double radius = s.c[0].w, growth = s.c[1].w;
    const double a = dot(way, way) - growth * growth, b = 2 * (dot(to, way) - radius * growth),
                 c = dot(to, to) - radius * radius, d = -2 * dot(way, l.direction), e = -2 * dot(to, l.direction);
    const double touching[3] = {4 * a * a - a * (d * d), 4 * a * b - 2 * a * (d * e),
                                b * b - b * (d * e) + c * (d * d)};
    double roots[2];
    const int n = solve_polynomial(2, touching, roots);
    for (int i = 0; i < n; ++i) {
      const double u = roots[i];
      if (!(u >= 0 && u <= 1)) continue;
      double near, far;
      if (std::fabs(d) > kAcross) {
        add_side(s, u, -(2 * a * u + b) / d, index, side, l, all);
      } else if (sphere_chord(s.at(u), l, near, far)) {
        add_side(s, u, near, index, chord, l, all);
        add_side(s, u, far, index, chord, l, all);
      }
    }
  }

  static void curved_side(const Segment& s, std::int32_t index, const LocalRay& l, Scratch<Intersection>& all) {
    const Spheres spheres(s, l);
    double touching[11], roots[10];
    [&]<std::size_t... N>(std::index_sequence<N...>) { ((touching[10 - N] = spheres.touching<N>()), ...); }
    (std::make_index_sequence<11>());
    // POV-Ray looks for no roots then, not even for one at 0, which a polynomial along a ray from afar often has.
    if (!changes_sign(touching)) return;
    const int count = solve_polynomial(10, touching, roots, true, 0, 0, 1);
    for (int i = 0; i < count; ++i) {
      const double u = roots[i];
      double enter, leave;
      if (!(u >= 0 && u <= 1)) continue;
      const Vec4 sphere = s.at(u);
      // Only one end of the chord lies on the envelope, but POV-Ray reports both.
      if (sphere_chord(sphere, l, enter, leave)) add_chord(enter, leave, u, index, chord, sphere.w, all);
    }
  }

  std::vector<Segment> segments_;
  double tolerance_;
  accel::Bvh tree_;
  // From farther away rounding has rays meet segments that they pass by.
  Vec3 center_{0, 0, 0};
  double far2_ = HUGE_VAL;
};

}  // namespace

std::unique_ptr<Shape> compile_sphere_sweep(const scene::Object& object) {
  return std::make_unique<SphereSweep>(object, **object.as<std::shared_ptr<const scene::SphereSweep>>());
}

}  // namespace verisim::shapes
