// superellipsoid (spec 03 4.12): nested p-norms, |(|(x, y)|_2/e, z)|_2/n = 1.
#include <algorithm>
#include <utility>

#include "tracer/shapes/convex.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_kernels.h"
#include "tracer/shapes/quadrics/plane_set.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/algebraic/superellipsoid_packet.h"
#include "tracer/shapes/algebraic/superellipsoid_search.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7, kCube = 1.01;
constexpr double kZero = SuperellipsoidSearch::kZero;

class Superellipsoid final : public Primitive<Superellipsoid>, public Convex {
 public:
  Superellipsoid(const scene::Object& description, const scene::Superellipsoid& s)
      : Primitive(description, {Box3(Vec3(-1.0001), Vec3(1.0001))}),
        search_(EllipsoidNorm(s.east), EllipsoidNorm(s.north)),
        guarded_(has_guards(description)) {
    constexpr double kDoubt = 1e-9;
    most_inside_ = (1 - kDoubt) * std::pow(2, -1 / search_.across().exponent - 1 / search_.all().exponent);
    least_outside_ = 1 + kDoubt;
    if (has_matrix())
      interval_ =
          length(Vec3(length(matrix().inverse_direction({1, 0, 0})), length(matrix().inverse_direction({0, 1, 0})),
                      length(matrix().inverse_direction({0, 0, 1}))));
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = unit_local(ray);
    double near, far;
    if (!clip_to_cube(l, near, far)) return;
    double outside = near;
    if (search_.convex()) {
      ConvexPacket packet{};
      if (!(approach_both(l, near, far, 1, packet) & 1)) return;
      outside = surely_outside_until(packet, 0);
    }
    search_.along(l, near, far, outside, -HUGE_VAL, [&](double t) {
      const double depth = t / l.scale;
      if (!(depth > kNearest && depth < kFarthest)) return false;
      const Vec3 p = ray.origin + depth * ray.direction;
      return sink.add(depth, [&] { return p; }) ? Sink::kNearest : ends_with(sink, p);
    });
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (guarded_ || !search_.convex()) return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    return nearest_of_packet(rays, t_min, t_max, [&](int k, double t) {
      const Ray ray = rays.at(k);
      hits[k] = {t, ray.origin + t * ray.direction, this, 0, 0, 0};
    });
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (guarded_ || !search_.convex()) return Shape::occludes_packet(rays, entry, t_min, t_max);
    return nearest_of_packet(rays, t_min, t_max, [](int, double) {});
  }

  bool crossed_once() const override { return search_.convex() && !inverted() && !guarded_; }
  Intersections cross(const Ray& ray) const override { return cross(ray, unit_local(ray)); }
  void cross_packet(const RayPacket& rays, Intersections* intersections) const override {
    each_lane(rays.active, [&](int k) { intersections[k] = {}; });
    PacketWays w;
    search_packet(rays, w, [&](int k, double depth) { return add_depth(depth, intersections[k]); });
    each_lane(w.entered, [&](int k) {
      narrow(w.locals[k], w.near[k], doubt_at(rays.rays.origin.at(rays.first + k)), w.entry, w.exit, w.left >> k & 1, k,
             k, intersections[k]);
    });
  }
  void intersect_packet_between(const RayPacket& rays, RayKind kind, const double* from, const double* to,
                                LaneHits& hits) const override {
    if (guarded_ || !search_.convex()) return Shape::intersect_packet_between(rays, kind, from, to, hits);
    constexpr int kMaxHits = 12;  // one at each knot
    double depths[ConvexPacket::kCount][kMaxHits];
    int counts[ConvexPacket::kCount] = {};
    PacketWays w;
    search_packet(rays, w, [&](int k, double depth) {
      if (depth > to[k]) return true;
      if (depth > kNearest && depth < kFarthest) depths[k][counts[k]++] = depth;
      return counts[k] == kMaxHits;
    });
    each_lane(w.entered, [&](int k) {
      const Ray ray = rays.at(k);
      HitList& list = hits.begin_lane(k);
      for (int i = 0; i < counts[k]; ++i)
        list.push_back({depths[k][i], ray.origin + depths[k][i] * ray.direction, this, 0, 0, 0});
      hits.end_lane(k);
    });
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    // The norm of three numbers is at least the largest of them, and at most so many times as much as it is for equal
    // ones.
    const double largest = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    if (largest > least_outside_) return false;
    return largest < most_inside_ || search_.value(p) < kZero;
  }

  // The gradient times 1 + (y / x)^p for x > y, with 1 - z^q for r^q, which is the same where the value is zero; in the
  // order that has all of POV-Ray's bits (spec 08 N).
  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 v = local(hit.point);
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    const double large = std::max(x, y), small = std::min(x, y);
    const double across = large > 0 ? search_.across().raise(small / large) : 0, along = search_.all().raise(z),
                 rest = 1 - along;
    // In a plane of coordinates the normal lies in it, though the surface may have an edge there.
    const auto part = [](double power, double base) { return base > 0 ? power / base : 0.0; };
    const double most = large > 0 ? rest / large : 0, least = part(rest * across, small);
    const Vec3 g(std::copysign(x < y ? least : most, v.x), std::copysign(x < y ? most : least, v.y),
                 std::copysign(part(along, z) * (1 + across), v.z));
    const double largest = std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return {1, 0, 0};
    return world_normal(g);
  }

 private:
  // Whether a search ends with a hit at `p` that does not count: outside CSG POV-Ray looks for one hit only, which may
  // be nearer than shadows begin.
  template <class Sink>
  static bool ends_with(const Sink& sink, const Vec3& p) {
    if constexpr (Sink::kNearest) return !sink.clipped_from_outside() && !sink.clipped(p);
    return false;
  }
  unsigned approach(double side, unsigned active, ConvexPacket& packet) const {
    if (active == 0) return 0;
    std::fill_n(packet.side, ConvexPacket::kCount, side);
    return superellipsoid_kernels().approach(search_.across().exponent, search_.all().exponent, active, packet);
  }
  // The entry in the first lane, the exit in the second.
  unsigned approach_both(const LocalRay& l, double near, double far, unsigned active, ConvexPacket& packet) const {
    set(packet, 0, l), set(packet, 1, l);
    packet.t[0] = near, packet.end[0] = far, packet.side[0] = 1;
    packet.t[1] = far, packet.end[1] = near, packet.side[1] = -1;
    return superellipsoid_kernels().approach_pair(search_.across().exponent, search_.all().exponent, active, packet);
  }
  static void set(ConvexPacket& packet, int k, const LocalRay& l) {
    packet.ox[k] = l.origin.x, packet.oy[k] = l.origin.y, packet.oz[k] = l.origin.z;
    packet.dx[k] = l.direction.x, packet.dy[k] = l.direction.y, packet.dz[k] = l.direction.z;
  }
  // A convex body has two hits at most. Returns whether these are both.
  static bool add_depth(double depth, Intersections& c) {
    if (depth > kNearest && depth < kFarthest) c.add(depth);
    return c.count == 2;
  }
  // Where one ray may be inside: lanes i and j tell of the entry and the exit, which were looked for from either end of
  // the cube. The exit would be found from behind the entry only; that the search for it may pass the entry, where it
  // finds nothing, does not matter.
  static void narrow(const LocalRay& l, double begin, double doubt, const ConvexPacket& entry, const ConvexPacket& exit,
                     bool left, int i, int j, Intersections& c) {
    // The value is convex along the ray: beyond its zeros it is above its tangents there.
    if (!(begin == kNearest && entry.t[i] == begin))
      c.near = (entry.t[i] - doubt / std::fabs(entry.slope[i])) / l.scale;
    if (left && exit.t[j] > entry.t[i]) c.far = (exit.t[j] + doubt / std::fabs(exit.slope[j])) / l.scale;
  }
  // How much the value changes, at most, where a point is off by PlaneSet::doubt_at; and what the inside test
  // tolerates.
  double doubt_at(const Vec3& origin) const { return 2 * interval_ * PlaneSet::doubt_at(origin) + 100 * kZero; }
  // The entry and the exit are looked for at the same time: each step is a long chain of operations that wait for each
  // other.
  Intersections cross(const Ray& ray, const LocalRay& l) const {
    double near, far;
    if (!clip_to_cube(l, near, far)) return {};
    ConvexPacket packet;
    const unsigned found = approach_both(l, near, far, 3, packet);
    if (!(found & 1)) return {};
    Intersections c;
    search_.along(l, near, far, surely_outside_until(packet, 0), found & 2 ? packet.t[1] : -HUGE_VAL,
                  [&](double t) { return add_depth(t / l.scale, c); });
    narrow(l, near, doubt_at(ray.origin), packet, packet, found & 2, 0, 1, c);
    return c;
  }
  // Where eight rays are within the cube, and come to the surface from either end of that.
  struct PacketWays {
    ConvexPacket entry{}, exit{};
    LocalRay locals[ConvexPacket::kCount];
    double near[ConvexPacket::kCount], far[ConvexPacket::kCount];
    unsigned entered = 0, left = 0;
  };
  // report(lane, depth) says whether the lane may stop.
  template <class Report>
  void search_packet(const RayPacket& rays, PacketWays& w, Report&& report) const {
    unsigned active = 0;
    each_lane(rays.active, [&](int k) {
      w.locals[k] = unit_local(rays.at(k));
      if (!clip_to_cube(w.locals[k], w.near[k], w.far[k])) return;
      set(w.entry, k, w.locals[k]), set(w.exit, k, w.locals[k]);
      w.entry.t[k] = w.exit.end[k] = w.near[k], w.entry.end[k] = w.exit.t[k] = w.far[k];
      active |= 1u << k;
    });
    w.entered = approach(1, active, w.entry), w.left = approach(-1, w.entered, w.exit);
    double from[ConvexPacket::kCount], to[ConvexPacket::kCount];
    each_lane(w.entered, [&](int k) {
      from[k] = surely_outside_until(w.entry, k), to[k] = w.left >> k & 1 ? w.exit.t[k] : -HUGE_VAL;
    });
    search_.along_packet(w.entered, w.locals, w.near, w.far, from, to,
                         [&](int k, double t) { return report(k, t / w.locals[k].scale); });
  }
  // Where eight rays meet it first: take(lane, t).
  template <class Take>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, Take&& take) const {
    ConvexPacket packet{};
    LocalRay locals[ConvexPacket::kCount];
    double near[ConvexPacket::kCount], far[ConvexPacket::kCount];
    unsigned active = 0, found = 0;
    each_lane(rays.active, [&](int k) {
      locals[k] = unit_local(rays.at(k));
      if (!clip_to_cube(locals[k], near[k], far[k])) return;
      set(packet, k, locals[k]);
      packet.t[k] = near[k], packet.end[k] = far[k];
      active |= 1u << k;
    });
    const unsigned entered = approach(1, active, packet);
    double from[ConvexPacket::kCount], to[ConvexPacket::kCount];
    each_lane(entered, [&](int k) { from[k] = surely_outside_until(packet, k), to[k] = -HUGE_VAL; });
    search_.along_packet(entered, locals, near, far, from, to, [&](int k, double t) {
      const double depth = t / locals[k].scale;
      if (!(depth > kNearest && depth < kFarthest)) return false;
      if (depth >= t_min && depth < t_max[k]) {
        found |= 1u << k;
        take(k, depth);
      }
      return true;
    });
    return found;
  }
  // Where a search from outside has arrived, the value is at most 2e-10. It lies above its tangent, so before this
  // distance it is greater than what counts as a hit.
  static double surely_outside_until(const ConvexPacket& packet, int k) {
    return packet.slope[k] < 0 ? packet.t[k] - 3 * kZero / -packet.slope[k] : -HUGE_VAL;
  }

  static bool clip_to_cube(const LocalRay& l, double& near, double& far) {
    near = kNearest, far = HUGE_VAL;
    const Vec3 &o = l.origin, &d = l.direction;
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(d[i]) < kEpsilon) {
        if (std::fabs(o[i]) > kCube) return false;
        continue;
      }
      double a = (-kCube - o[i]) / d[i], b = (kCube - o[i]) / d[i];
      if (a > b) std::swap(a, b);
      near = std::max(near, a), far = std::min(far, b);
      if (!(near < far)) return false;
    }
    return true;
  }

  SuperellipsoidSearch search_;
  double interval_ = 2;                 // nothing grows more than this much on the way to local coordinates
  double most_inside_, least_outside_;  // of coordinates: where the formula need not be asked
  bool guarded_;
};

}  // namespace

std::unique_ptr<Shape> compile_superellipsoid(const scene::Object& object) {
  return std::make_unique<Superellipsoid>(object, *object.as<scene::Superellipsoid>());
}

}  // namespace verisim::shapes
