// superellipsoid (spec 03 4.12): nested p-norms, |(|(x, y)|_2/e, z)|_2/n = 1.
#include <algorithm>

#include "tracer/shapes/convex.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_kernels.h"
#include "tracer/shapes/quadrics/plane_set.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/algebraic/superellipsoid_packet.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7, kZero = 1e-10, kCube = 1.01;
constexpr int kMaxSteps = 20;

// x^p and x^(1/p), without the library's pow where p is a small integer or a power of two: as most exponents in scenes
// are.
class Power {
 public:
  explicit Power(double p) : p_(p), inverse_(1 / p) {
    if (p >= 1 && p <= 64 && p == std::floor(p)) integer_ = static_cast<int>(p);
    if (integer_ > 0 && (integer_ & (integer_ - 1)) == 0)
      for (int i = integer_; i > 1; i /= 2) ++roots_;
    else
      roots_ = -1;
  }
  double exponent() const { return p_; }
  double raise(double x) const {
    if (integer_ == 0) return std::pow(x, p_);
    double result = 1;
    for (int n = integer_; n != 0; n >>= 1, x *= x)
      if (n & 1) result *= x;
    return result;
  }
  double root(double x) const {
    if (x == 1) return 1;  // most of a body with sharp edges
    if (roots_ < 0) return std::pow(x, inverse_);
    for (int i = 0; i < roots_; ++i) x = std::sqrt(x);
    return x;
  }

 private:
  double p_, inverse_;
  int integer_ = 0, roots_ = 0;  // roots_: how many square roots make x^(1/p); negative: use pow
};

double norm(double a, double b, const Power& p) {
  if (a < b) std::swap(a, b);
  if (!(a > 0)) return 0;
  return a * p.root(1 + p.raise(b / a));
}

class Superellipsoid final : public Primitive<Superellipsoid>, public Convex {
 public:
  Superellipsoid(const scene::Object& description, const scene::Superellipsoid& s)
      : Primitive(description, {Box3(Vec3(-1.0001), Vec3(1.0001))}),
        p_(2 / s.east),
        q_(2 / s.north),
        p_less_(p_.exponent() - 1),
        q_less_(q_.exponent() - 1),
        guarded_(has_guards(description)) {
    constexpr double kDoubt = 1e-9;
    most_inside_ = (1 - kDoubt) * std::pow(2, -1 / p_.exponent() - 1 / q_.exponent()), least_outside_ = 1 + kDoubt;
    if (has_matrix())
      interval_ =
          length(Vec3(length(matrix().inverse_direction({1, 0, 0})), length(matrix().inverse_direction({0, 1, 0})),
                      length(matrix().inverse_direction({0, 0, 1}))));
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    if (convex()) return convex_intersections(ray, l, sink);
    double knots[11];
    const int count = knots_of(l, knots);
    if (count < 2) return;
    // True when the search may stop: the sink wants the nearest hit and has taken this one.
    const auto report = [&](double t) {
      const double depth = t / l.scale;
      if (!(depth > kNearest && depth < kFarthest)) return false;
      return sink.add(depth, [&] { return ray.origin + depth * ray.direction; }) && Sink::kNearest;
    };
    double a = knots[0], fa = value(l, a);
    if (std::fabs(fa) < kZero && report(a)) return;
    for (int i = 1; i < count; ++i) {
      const double b = knots[i], fb = value(l, b);
      if (std::fabs(fb) < kZero) {
        if (report(b)) return;
      } else if (std::fabs(fa) >= kZero) {
        if ((fa < 0) != (fb < 0)) {
          if (report(refine(l, a, fa, b, fb))) return;
        } else if (double entry; fa > 0 && grazing_entry(l, a, fa, b, entry)) {
          if (report(entry)) return;
          double inner = entry;
          if (find_inside(l, entry, b, inner) && report(refine(l, inner, value(l, inner), b, fb))) return;
        }
      }
      a = b, fa = fb;
    }
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (guarded_ || !convex()) return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    return nearest_of_packet(rays, t_min, t_max, [&](int k, double t) {
      const Ray ray = rays.at(k);
      hits[k] = {t, ray.origin + t * ray.direction, this, 0, 0, 0};
    });
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (guarded_ || !convex()) return Shape::occludes_packet(rays, entry, t_min, t_max);
    return nearest_of_packet(rays, t_min, t_max, [](int, double) {});
  }

  bool crossed_once() const override { return convex() && !inverted() && !guarded_; }
  Intersections cross(const Ray& ray) const override { return cross(ray, local(ray)); }
  void cross_packet(const RayPacket& rays, Intersections* intersections) const override {
    ConvexPacket entry{}, exit{};
    double near[ConvexPacket::kCount], scale[ConvexPacket::kCount];
    unsigned active = 0;
    each_lane(rays.active, [&](int k) {
      intersections[k] = {};
      const LocalRay l = local(rays.at(k));
      double far;
      if (!clip_to_cube(l, near[k], far)) return;
      set(entry, k, l), set(exit, k, l);
      scale[k] = l.scale;
      entry.t[k] = exit.end[k] = near[k], entry.end[k] = exit.t[k] = far;
      active |= 1u << k;
    });
    const unsigned entered = approach(1, active, entry), left = approach(-1, entered, exit);
    each_lane(entered, [&](int k) {
      intersections[k] = found_from(near[k], scale[k], doubt_at(rays.rays.origin.at(rays.first + k)), entry, true, exit,
                                    left >> k & 1, k, k);
    });
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    // The norm of three numbers is at least the largest of them, and at most so many times as much as it is for equal
    // ones.
    const double largest = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    if (largest > least_outside_) return false;
    return largest < most_inside_ || value(p) < kZero;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 v = local(hit.point);
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    const double r = norm(x, y, p_), f = norm(r, z, q_);
    const auto raised = [](double ratio, const Power& power) { return ratio == 1 ? 1 : power.raise(ratio); };
    const double across = f > 0 && r > 0 ? raised(r / f, q_less_) : 0;
    const auto part = [&](double a, double size, const Power& power) {
      return size > 0 && a > 0 ? raised(a / size, power) : power.exponent() == 0 ? 1.0 : 0.0;
    };
    const Vec3 g(std::copysign(across * part(x, r, p_less_), v.x), std::copysign(across * part(y, r, p_less_), v.y),
                 std::copysign(part(z, f, q_less_), v.z));
    const double largest = std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return {1, 0, 0};
    return world_normal(g / largest);
  }

 private:
  double value(const Vec3& p) const { return norm(norm(std::fabs(p.x), std::fabs(p.y), p_), std::fabs(p.z), q_) - 1; }
  double value(const LocalRay& l, double t) const { return value(l.origin + t * l.direction); }

  // With exponents of at least 1 the nested norms are convex: a ray enters once and leaves once, and Newton's method
  // from outside goes straight to each.
  bool convex() const { return p_.exponent() >= 1 && q_.exponent() >= 1; }
  unsigned approach(double side, unsigned active, ConvexPacket& packet) const {
    if (active == 0) return 0;
    std::fill_n(packet.side, ConvexPacket::kCount, side);
    return superellipsoid_kernels().approach(p_.exponent(), q_.exponent(), active, packet);
  }
  static void set(ConvexPacket& packet, int k, const LocalRay& l) {
    packet.ox[k] = l.origin.x, packet.oy[k] = l.origin.y, packet.oz[k] = l.origin.z;
    packet.dx[k] = l.direction.x, packet.dy[k] = l.direction.y, packet.dz[k] = l.direction.z;
  }
  // The lanes of `active` that begin within the surface: only rays do that which begin within the cube around it.
  unsigned beginning_inside(unsigned active, ConvexPacket& packet) const {
    unsigned begin_here = 0, inside = 0;
    each_lane(active, [&](int k) { begin_here |= packet.t[k] == kNearest ? 1u << k : 0; });
    if (begin_here == 0) return 0;
    superellipsoid_kernels().value(p_.exponent(), q_.exponent(), packet);
    each_lane(begin_here, [&](int k) { inside |= packet.value[k] <= -kZero ? 1u << k : 0; });
    return inside;
  }

  // What is known of one ray: where it enters the cube, and lanes in which the entry and the exit were looked for from
  // either end of the interval within it. The exit would be found from behind the entry only; that the search for it
  // may pass the entry, where it finds nothing, does not matter.
  Intersections found_from(double begin, double scale, double doubt, const ConvexPacket& entry, bool entered,
                           const ConvexPacket& exit, bool left, int i, int j) const {
    Intersections c;
    if (!entered) return c;
    const auto take = [&](double t) {
      const double depth = t / scale;
      if (depth > kNearest && depth < kFarthest) c.add(depth);
    };
    const bool begins_here = begin == kNearest && entry.t[i] == begin;
    if (!(begins_here && entry.value[i] <= -kZero)) take(entry.t[i]);
    const bool leaves = left && exit.t[j] > entry.t[i];
    if (leaves) take(exit.t[j]);
    // The value is convex along the ray: beyond its zeros it is above its tangents there.
    if (!begins_here) c.near = (entry.t[i] - doubt / std::fabs(entry.slope[i])) / scale;
    if (leaves) c.far = (exit.t[j] + doubt / std::fabs(exit.slope[j])) / scale;
    return c;
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
    set(packet, 0, l), set(packet, 1, l);
    packet.t[0] = near, packet.end[0] = far, packet.side[0] = 1;
    packet.t[1] = far, packet.end[1] = near, packet.side[1] = -1;
    const unsigned found = superellipsoid_kernels().approach_pair(p_.exponent(), q_.exponent(), 3, packet);
    return found_from(near, l.scale, doubt_at(ray.origin), packet, found & 1, packet, found & 2, 0, 1);
  }
  template <class Sink>
  void convex_intersections(const Ray& ray, const LocalRay& l, Sink& sink) const {
    const Intersections c = cross(ray, l);
    for (int i = 0; i < c.count; ++i)
      if (sink.add(c.t[i], [&] { return ray.origin + c.t[i] * ray.direction; }) && Sink::kNearest) return;
  }
  // The same for eight rays: take(lane, t) for the nearest hits.
  template <class Take>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, Take&& take) const {
    ConvexPacket packet{};
    double near[ConvexPacket::kCount], far[ConvexPacket::kCount], scale[ConvexPacket::kCount];
    unsigned active = 0, found = 0;
    each_lane(rays.active, [&](int k) {
      const LocalRay l = local(rays.at(k));
      if (!clip_to_cube(l, near[k], far[k])) return;
      set(packet, k, l);
      scale[k] = l.scale;
      packet.t[k] = near[k], packet.end[k] = far[k];
      active |= 1u << k;
    });
    const auto report = [&](int k) {
      const double depth = packet.t[k] / scale[k];
      if (!(depth > kNearest && depth < kFarthest && depth >= t_min && depth < t_max[k])) return;
      found |= 1u << k;
      take(k, depth);
    };
    const unsigned inside = beginning_inside(active, packet), entered = approach(1, active & ~inside, packet);
    each_lane(entered, [&](int k) {
      report(k);
      near[k] = packet.t[k];
    });
    const unsigned leaving = inside | (entered & ~found);
    each_lane(leaving, [&](int k) { packet.t[k] = far[k], packet.end[k] = near[k]; });
    each_lane(approach(-1, leaving, packet), [&](int k) {
      if (packet.t[k] > near[k]) report(k);
    });
    return found;
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

  // Where the ray enters and leaves the cube, and crosses the planes of symmetry in between; sorted.
  static int knots_of(const LocalRay& l, double* knots) {
    double near, far;
    if (!clip_to_cube(l, near, far)) return 0;
    const Vec3 &o = l.origin, &d = l.direction;
    int n = 0;
    knots[n++] = near;
    const auto cross_plane = [&](double distance, double slope) {
      if (slope == 0) return;
      const double t = -distance / slope;
      if (t > near && t < far) knots[n++] = t;
    };
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      cross_plane(o[i], d[i]);
      cross_plane(o[i] - o[j], d[i] - d[j]);
      cross_plane(o[i] + o[j], d[i] + d[j]);
    }
    knots[n++] = far;
    std::sort(knots, knots + n);
    return n;
  }

  // The root between a and b, where the signs differ: secant steps, kept in the bracket by bisection.
  double refine(const LocalRay& l, double a, double fa, double b, double fb) const {
    double t = 0.5 * (a + b);
    for (int step = 0; step < 2 * kMaxSteps; ++step) {
      t = step % 3 == 2 ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
      const double f = value(l, t);
      if (std::fabs(f) < kZero) return t;
      if ((f < 0) == (fa < 0))
        a = t, fa = f;
      else
        b = t, fb = f;
    }
    return t;
  }

  // Outside at both ends of a interval: a secant walk from the near end, which finds an entry if the ray dips below the
  // surface.
  bool grazing_entry(const LocalRay& l, double a, double fa, double b, double& entry) const {
    double t0 = a, f0 = fa, t1 = a + 1e-4 * (b - a), f1 = value(l, t1);
    for (int step = 0; step < kMaxSteps; ++step) {
      if (std::fabs(f1) < kZero) {
        entry = t1;
        return true;
      }
      if (f1 < 0) {
        entry = refine(l, t0, f0, t1, f1);
        return true;
      }
      if (f1 == f0) return false;
      const double t = t1 - f1 * (t1 - t0) / (f1 - f0);
      if (!(t > t1 && t <= b)) return false;
      t0 = t1, f0 = f1;
      t1 = t, f1 = value(l, t);
    }
    return false;
  }

  // A point with a negative value behind a grazing entry.
  bool find_inside(const LocalRay& l, double entry, double b, double& inner) const {
    for (double step = 1e-6; entry + step < b; step *= 4) {
      inner = entry + step;
      const double f = value(l, inner);
      if (f < -kZero) return true;
    }
    return false;
  }

  Power p_, q_, p_less_, q_less_;       // the exponents, and these less 1
  double interval_ = 2;                 // nothing grows more than this much on the way to local coordinates
  double most_inside_, least_outside_;  // of coordinates: where the formula need not be asked
  bool guarded_;
};

}  // namespace

std::unique_ptr<Shape> compile_superellipsoid(const scene::Object& object) {
  return std::make_unique<Superellipsoid>(object, *object.as<scene::Superellipsoid>());
}

}  // namespace verisim::shapes
