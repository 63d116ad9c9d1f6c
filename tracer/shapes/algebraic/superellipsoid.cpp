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

// |(a, b)|_p, p = 2 / e, as POV-Ray has it, bit by bit: powers by multiplication where p is a small integer.
class Norm {
 public:
  explicit Norm(double e) : p_(2 / e), inverse_(1 / p_), negligible_(std::pow(2, -54 / p_)) {
    if (p_ >= 1 && p_ <= 6 && p_ == std::floor(p_)) integer_ = static_cast<int>(p_);
  }
  double exponent() const { return p_; }
  double operator()(double a, double b) const {
    if (a < b) std::swap(a, b);
    if (!(a > 0)) return 0;
    const double ratio = b / a;
    if (ratio < negligible_) return a;
    const double sum = 1 + raise(ratio);
    return sum == 1 ? a : a * std::pow(sum, inverse_);  // most of a body with sharp edges
  }
  // x^p
  double raise(double x) const {
    if (integer_ == 0) return std::pow(x, p_);
    double result = 1;
    for (int n = integer_; n != 0; n >>= 1, x *= x)
      if (n & 1) result *= x;
    return result;
  }

 private:
  double p_, inverse_;
  double negligible_;  // 1 + x^p is 1 below it
  int integer_ = 0;
};

// A point of a ray in the shape's own space, and the value there.
struct Sample {
  Vec3 p;
  double value;
};
bool opposite(const Sample& a, const Sample& b) { return (a.value < 0) != (b.value < 0); }

class Superellipsoid final : public Primitive<Superellipsoid>, public Convex {
 public:
  Superellipsoid(const scene::Object& description, const scene::Superellipsoid& s)
      : Primitive(description, {Box3(Vec3(-1.0001), Vec3(1.0001))}),
        across_(s.east),
        all_(s.north),
        guarded_(has_guards(description)) {
    constexpr double kDoubt = 1e-9;
    most_inside_ = (1 - kDoubt) * std::pow(2, -1 / across_.exponent() - 1 / all_.exponent());
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
    if (convex()) {
      ConvexPacket packet{};
      if (!(approach_both(l, near, far, 1, packet) & 1)) return;
      outside = surely_outside_until(packet, 0);
    }
    search(l, near, far, outside, -HUGE_VAL, [&](double t) {
      const double depth = t / l.scale;
      if (!(depth > kNearest && depth < kFarthest)) return false;
      return sink.add(depth, [&] { return ray.origin + depth * ray.direction; }) && Sink::kNearest;
    });
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
  Intersections cross(const Ray& ray) const override { return cross(ray, unit_local(ray)); }
  void cross_packet(const RayPacket& rays, Intersections* intersections) const override {
    ConvexPacket entry{}, exit{};
    LocalRay locals[ConvexPacket::kCount];
    double near[ConvexPacket::kCount], far[ConvexPacket::kCount];
    unsigned active = 0;
    each_lane(rays.active, [&](int k) {
      intersections[k] = {};
      locals[k] = unit_local(rays.at(k));
      if (!clip_to_cube(locals[k], near[k], far[k])) return;
      set(entry, k, locals[k]), set(exit, k, locals[k]);
      entry.t[k] = exit.end[k] = near[k], entry.end[k] = exit.t[k] = far[k];
      active |= 1u << k;
    });
    const unsigned entered = approach(1, active, entry), left = approach(-1, entered, exit);
    each_lane(entered, [&](int k) {
      intersections[k] = found_from(locals[k], near[k], far[k], doubt_at(rays.rays.origin.at(rays.first + k)), entry,
                                    exit, left >> k & 1, k, k);
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

  // The gradient times 1 + (y / x)^p for x > y, with 1 - z^q for r^q, which is the same where the value is zero; in the
  // order that has all of POV-Ray's bits (spec 08 N).
  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 v = local(hit.point);
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    const double large = std::max(x, y), small = std::min(x, y);
    const double across = large > 0 ? across_.raise(small / large) : 0, along = all_.raise(z), rest = 1 - along;
    const auto part = [](double power, double base, const Norm& norm) {
      return base > 0 ? power / base : norm.exponent() == 1 ? 1.0 : 0.0;
    };
    const double most = large > 0 ? rest / large : 0, least = part(rest * across, small, across_);
    const Vec3 g(std::copysign(x < y ? least : most, v.x), std::copysign(x < y ? most : least, v.y),
                 std::copysign(part(along, z, all_) * (1 + across), v.z));
    const double largest = std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return {1, 0, 0};
    return world_normal(g);
  }

 private:
  double value(const Vec3& p) const { return all_(across_(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)) - 1; }
  Sample sample(const Vec3& p) const { return {p, value(p)}; }
  Sample sample(const LocalRay& l, double t) const { return sample(l.origin + t * l.direction); }

  // With exponents of at least 1 the nested norms are convex: a ray enters once and leaves once, and Newton's method
  // from outside goes straight to each.
  bool convex() const { return across_.exponent() >= 1 && all_.exponent() >= 1; }
  unsigned approach(double side, unsigned active, ConvexPacket& packet) const {
    if (active == 0) return 0;
    std::fill_n(packet.side, ConvexPacket::kCount, side);
    return superellipsoid_kernels().approach(across_.exponent(), all_.exponent(), active, packet);
  }
  // The entry in the first lane, the exit in the second.
  unsigned approach_both(const LocalRay& l, double near, double far, unsigned active, ConvexPacket& packet) const {
    set(packet, 0, l), set(packet, 1, l);
    packet.t[0] = near, packet.end[0] = far, packet.side[0] = 1;
    packet.t[1] = far, packet.end[1] = near, packet.side[1] = -1;
    return superellipsoid_kernels().approach_pair(across_.exponent(), all_.exponent(), active, packet);
  }
  static void set(ConvexPacket& packet, int k, const LocalRay& l) {
    packet.ox[k] = l.origin.x, packet.oy[k] = l.origin.y, packet.oz[k] = l.origin.z;
    packet.dx[k] = l.direction.x, packet.dy[k] = l.direction.y, packet.dz[k] = l.direction.z;
  }
  // What is known of one ray: where it is within the cube, and lanes in which the entry and the exit were looked for
  // from either end of that interval. The exit would be found from behind the entry only; that the search for it may
  // pass the entry, where it finds nothing, does not matter.
  Intersections found_from(const LocalRay& l, double begin, double end, double doubt, const ConvexPacket& entry,
                           const ConvexPacket& exit, bool left, int i, int j) const {
    Intersections c;
    search(l, begin, end, surely_outside_until(entry, i), left ? exit.t[j] : -HUGE_VAL, [&](double t) {
      const double depth = t / l.scale;
      if (depth > kNearest && depth < kFarthest) c.add(depth);
      return c.count == 2;
    });
    // The value is convex along the ray: beyond its zeros it is above its tangents there.
    if (!(begin == kNearest && entry.t[i] == begin))
      c.near = (entry.t[i] - doubt / std::fabs(entry.slope[i])) / l.scale;
    if (left && exit.t[j] > entry.t[i]) c.far = (exit.t[j] + doubt / std::fabs(exit.slope[j])) / l.scale;
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
    const unsigned found = approach_both(l, near, far, 3, packet);
    if (!(found & 1)) return {};
    return found_from(l, near, far, doubt_at(ray.origin), packet, packet, found & 2, 0, 1);
  }
  // The same for eight rays: take(lane, t) for the nearest hits.
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
    each_lane(approach(1, active, packet), [&](int k) {
      search(locals[k], near[k], far[k], surely_outside_until(packet, k), -HUGE_VAL, [&](double t) {
        const double depth = t / locals[k].scale;
        if (!(depth > kNearest && depth < kFarthest && depth >= t_min && depth < t_max[k])) return false;
        found |= 1u << k;
        take(k, depth);
        return true;
      });
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

  // Where the ray enters and leaves the cube, and crosses the planes of symmetry in between; sorted.
  static int knots_of(const LocalRay& l, double near, double far, double* knots) {
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

  // POV-Ray's search from `near` to `far`, step by step, because it stops where the value is within 1e-10 of zero: its
  // steps decide the last bits of hits, and which hits are lost. Up to `outside` there is none; near `exit` a convex
  // one is left (-HUGE_VAL: unknown). report(t) says whether it may stop.
  template <class Report>
  void search(const LocalRay& l, double near, double far, double outside, double exit, Report&& report) const {
    double knots[11];
    const int count = knots_of(l, near, far, knots);
    int i = 1;
    while (i < count - 1 && knots[i] < outside) ++i;
    Sample a = sample(l, knots[i - 1]);
    if (std::fabs(a.value) < kZero && report(knots[i - 1])) return;
    for (; i < count; ++i) {
      const Sample b = sample(l, knots[i]);
      if (std::fabs(b.value) < kZero) {
        if (report(knots[i])) return;
      } else if (std::fabs(a.value) >= kZero) {
        double t;
        if (opposite(a, b)) {
          if (report(refined(l, a, b))) return;
        } else if (a.value > 0 && grazing_entry(l, knots[i - 1], a, knots[i], t)) {
          if (report(t)) return;
        }
      }
      a = b;
      if (i + 1 < count && well_inside(a)) pass_inside(l, knots, exit, i, a);
    }
  }

  static bool well_inside(const Sample& a) { return a.value < -2 * kZero; }
  // Between two points that are well inside all is, so the last knot `a`, of index i, may as well be the last of all
  // before the exit.
  void pass_inside(const LocalRay& l, const double* knots, double exit, int& i, Sample& a) const {
    int last = i;
    while (knots[last + 1] < exit) ++last;
    if (last == i) return;
    const Sample there = sample(l, knots[last]);
    if (well_inside(there)) i = last, a = there;
  }

  // The root between two points at which the signs differ: the secant from the first point, and the middle. Where their
  // signs differ, they are the next two points; otherwise the one with the smaller value takes the place of that with
  // its sign.
  double refined(const LocalRay& l, Sample a, Sample b) const {
    Sample secant{};
    for (int step = 0; step < kMaxSteps; ++step) {
      secant = sample(a.p + a.value / (a.value - b.value) * (b.p - a.p));
      if (std::fabs(secant.value) < kZero) break;
      if (middle_is_deeper(a, b, secant)) {
        b = secant;
        continue;
      }
      if (middle_is_deeper(b, a, secant)) {
        a = secant;
        continue;
      }
      const Sample middle = sample(0.5 * (a.p + b.p));
      if (std::fabs(middle.value) < kZero) return length(middle.p - l.origin);
      if (opposite(secant, middle)) {
        a = secant, b = middle;
      } else {
        const Sample& next = std::fabs(secant.value) < std::fabs(middle.value) ? secant : middle;
        (opposite(next, a) ? b : a) = next;
      }
    }
    return length(secant.p - l.origin);
  }

  // Whether the value in the middle between a point outside and one inside, which lies behind the secant's, is surely
  // below the secant's, so that it need not be known. A convex value there is at most what the straight line from the
  // secant's point to that inside has.
  bool middle_is_deeper(const Sample& outside, const Sample& inside, const Sample& secant) const {
    constexpr double kDoubt = 1e-12;  // more than values can be off
    if (!(convex() && outside.value > 0 && secant.value < 0)) return false;
    const double at = outside.value / (outside.value - inside.value);  // of the secant's point, from outside
    return at < 0.5 && (0.5 - at) * (secant.value - inside.value) > kDoubt;
  }

  // Outside at both ends of an interval: secants from the near end, which find an entry if the ray dips below the
  // surface. Its exit is lost.
  bool grazing_entry(const LocalRay& l, double begin, const Sample& a, double end, double& entry) const {
    double t0 = begin, f0 = a.value;
    entry = begin + 1e-4 * (end - begin);
    for (int step = 0; step < kMaxSteps; ++step) {
      const Sample here = sample(l, entry);
      const double f = here.value;
      if (std::fabs(f) < kZero) return true;
      if (f < 0) {  // only where the norms are not convex
        entry = refined(l, sample(l, t0), here);
        return true;
      }
      if (!(f < f0)) return false;
      const double next = entry - f * (entry - t0) / (f - f0);
      if (!(next <= end)) return false;
      t0 = entry, f0 = f, entry = next;
    }
    return false;
  }

  Norm across_, all_;                   // of x and y, of that and z
  double interval_ = 2;                 // nothing grows more than this much on the way to local coordinates
  double most_inside_, least_outside_;  // of coordinates: where the formula need not be asked
  bool guarded_;
};

}  // namespace

std::unique_ptr<Shape> compile_superellipsoid(const scene::Object& object) {
  return std::make_unique<Superellipsoid>(object, *object.as<scene::Superellipsoid>());
}

}  // namespace verisim::shapes
