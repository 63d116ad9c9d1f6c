// superellipsoid (spec 03 4.12): nested p-norms, |(|(x, y)|_2/e, z)|_2/n = 1.
#include <algorithm>
#include <utility>

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

// A point of a ray in the shape's own space, and the value there.
struct Sample {
  Vec3 p;
  double value;
};
bool opposite(const Sample& a, const Sample& b) { return (a.value < 0) != (b.value < 0); }

// The search for the root between two points at which the signs differ: the secant from the first point, and the
// middle. Where their signs differ, they are the next two points; otherwise the one with the smaller value takes the
// place of that with its sign.
class Root {
 public:
  Root() {}
  Root(const Sample& a, const Sample& b, bool convex) : a_(a), b_(b), convex_(convex) { aim(); }
  Vec3 at;  // where the value is wanted; at last the root
  // Goes on with the value; true: it is found.
  bool take(double value) {
    if (!halves_) {
      secant_ = {at, value};
      if (std::fabs(value) < kZero) return true;
      if (middle_is_deeper(a_, b_)) {
        b_ = secant_;
      } else if (middle_is_deeper(b_, a_)) {
        a_ = secant_;
      } else {
        halves_ = true;
        at = 0.5 * (a_.p + b_.p);
        return false;
      }
    } else {
      if (std::fabs(value) < kZero) return true;
      halves_ = false;
      const Sample middle{at, value};
      if (opposite(secant_, middle)) {
        a_ = secant_, b_ = middle;
      } else {
        if (!(std::fabs(secant_.value) < std::fabs(middle.value))) secant_ = middle;
        (opposite(secant_, a_) ? b_ : a_) = secant_;
      }
    }
    if (++steps_ == kMaxSteps) {
      at = secant_.p;
      return true;
    }
    aim();
    return false;
  }

 private:
  void aim() { at = a_.p + a_.value / (a_.value - b_.value) * (b_.p - a_.p); }
  // Whether the value in the middle between a point outside and one inside, which lies behind the secant's, is surely
  // below the secant's, so that it need not be known. A convex value there is at most what the straight line from the
  // secant's point to that inside has.
  bool middle_is_deeper(const Sample& outside, const Sample& inside) const {
    constexpr double kDoubt = 1e-12;  // more than values can be off
    if (!(convex_ && outside.value > 0 && secant_.value < 0)) return false;
    const double place = outside.value / (outside.value - inside.value);  // of the secant's point, from outside
    return place < 0.5 && (0.5 - place) * (secant_.value - inside.value) > kDoubt;
  }

  Sample a_, b_, secant_;  // the third at last: the point that counts
  int steps_ = 0;
  bool convex_, halves_ = false;
};

class Superellipsoid final : public Primitive<Superellipsoid>, public Convex {
 public:
  Superellipsoid(const scene::Object& description, const scene::Superellipsoid& s)
      : Primitive(description, {Box3(Vec3(-1.0001), Vec3(1.0001))}),
        across_(s.east),
        all_(s.north),
        guarded_(has_guards(description)) {
    constexpr double kDoubt = 1e-9;
    most_inside_ = (1 - kDoubt) * std::pow(2, -1 / across_.exponent - 1 / all_.exponent);
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
      const Vec3 p = ray.origin + depth * ray.direction;
      return sink.add(depth, [&] { return p; }) ? Sink::kNearest : ends_with(sink, p);
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
    double from[ConvexPacket::kCount], to[ConvexPacket::kCount];
    each_lane(entered,
              [&](int k) { from[k] = surely_outside_until(entry, k), to[k] = left >> k & 1 ? exit.t[k] : -HUGE_VAL; });
    search_packet(entered, locals, near, far, from, to,
                  [&](int k, double t) { return add_depth(t / locals[k].scale, intersections[k]); });
    each_lane(entered, [&](int k) {
      narrow(locals[k], near[k], doubt_at(rays.rays.origin.at(rays.first + k)), entry, exit, left >> k & 1, k, k,
             intersections[k]);
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
    const auto part = [](double power, double base, const EllipsoidNorm& norm) {
      return base > 0 ? power / base : norm.exponent == 1 ? 1.0 : 0.0;
    };
    const double most = large > 0 ? rest / large : 0, least = part(rest * across, small, across_);
    const Vec3 g(std::copysign(x < y ? least : most, v.x), std::copysign(x < y ? most : least, v.y),
                 std::copysign(part(along, z, all_) * (1 + across), v.z));
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
  double value(const Vec3& p) const { return all_(across_(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)) - 1; }
  Sample sample(const Vec3& p) const { return {p, value(p)}; }
  static Vec3 point(const LocalRay& l, double t) { return l.origin + t * l.direction; }
  Sample sample(const LocalRay& l, double t) const { return sample(point(l, t)); }
  // The values at the points of the samples of these lanes.
  void evaluate(Sample* samples, unsigned lanes) const {
    Vec3 points[EllipsoidPoints::kCount];
    double found[EllipsoidPoints::kCount];
    int count = 0;
    each_lane(lanes, [&](int k) { points[count++] = samples[k].p; });
    values(points, count, found);
    count = 0;
    each_lane(lanes, [&](int k) { samples[k].value = found[count++]; });
  }
  void values(const Vec3* points, int count, double* found) const {
    constexpr int kWorthAPacket = 3, kCount = EllipsoidPoints::kCount;
    for (; count >= kWorthAPacket; points += kCount, found += kCount, count -= kCount) {
      const int n = std::min(count, kCount);
      EllipsoidPoints packet;
      alignas(64) double norms[kCount];
      for (int k = 0; k < kCount; ++k) {
        const Vec3& p = points[std::min(k, n - 1)];
        packet.x[k] = p.x, packet.y[k] = p.y, packet.z[k] = p.z;
      }
      superellipsoid_kernels().norms(across_, all_, (1u << n) - 1, packet, norms);
      for (int k = 0; k < n; ++k) found[k] = norms[k] - 1;
    }
    for (int k = 0; k < count; ++k) found[k] = value(points[k]);
  }
  // With exponents of at least 1 the nested norms are convex: a ray enters once and leaves once, and Newton's method
  // from outside goes straight to each.
  bool convex() const { return across_.exponent >= 1 && all_.exponent >= 1; }
  unsigned approach(double side, unsigned active, ConvexPacket& packet) const {
    if (active == 0) return 0;
    std::fill_n(packet.side, ConvexPacket::kCount, side);
    return superellipsoid_kernels().approach(across_.exponent, all_.exponent, active, packet);
  }
  // The entry in the first lane, the exit in the second.
  unsigned approach_both(const LocalRay& l, double near, double far, unsigned active, ConvexPacket& packet) const {
    set(packet, 0, l), set(packet, 1, l);
    packet.t[0] = near, packet.end[0] = far, packet.side[0] = 1;
    packet.t[1] = far, packet.end[1] = near, packet.side[1] = -1;
    return superellipsoid_kernels().approach_pair(across_.exponent, all_.exponent, active, packet);
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
    search(l, near, far, surely_outside_until(packet, 0), found & 2 ? packet.t[1] : -HUGE_VAL,
           [&](double t) { return add_depth(t / l.scale, c); });
    narrow(l, near, doubt_at(ray.origin), packet, packet, found & 2, 0, 1, c);
    return c;
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
    const unsigned entered = approach(1, active, packet);
    double from[ConvexPacket::kCount], to[ConvexPacket::kCount];
    each_lane(entered, [&](int k) { from[k] = surely_outside_until(packet, k), to[k] = -HUGE_VAL; });
    search_packet(entered, locals, near, far, from, to, [&](int k, double t) {
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

  // Where a ray enters and leaves the cube, and crosses the planes of symmetry in between; sorted. `next` is the end of
  // the interval that a search has come to: the first that does not end before `outside`.
  struct Knots {
    double at[11];
    int count, next;

    Knots() {}
    Knots(const LocalRay& l, double near, double far, double outside) : count(0), next(1) {
      const Vec3 &o = l.origin, &d = l.direction;
      at[count++] = near;
      const auto cross_plane = [&](double distance, double slope) {
        if (slope == 0) return;
        const double t = -distance / slope;
        if (t > near && t < far) at[count++] = t;
      };
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        cross_plane(o[i], d[i]);
        cross_plane(o[i] - o[j], d[i] - d[j]);
        cross_plane(o[i] + o[j], d[i] + d[j]);
      }
      at[count++] = far;
      std::sort(at, at + count);
      while (next < count - 1 && at[next] < outside) ++next;
    }
    bool done() const { return next >= count; }
    double before() const { return at[next - 1]; }
    double here() const { return at[next]; }
    int last_before(double t) const {
      int last = next;
      while (last + 1 < count && at[last + 1] < t) ++last;
      return last;
    }
  };

  // POV-Ray's search from `near` to `far`, step by step, because it stops where the value is within 1e-10 of zero: its
  // steps decide the last bits of hits, and which hits are lost. Up to `outside` there is none; near `exit` a convex
  // one is left (-HUGE_VAL: unknown). report(t) says whether it may stop.
  template <class Report>
  void search(const LocalRay& l, double near, double far, double outside, double exit, Report&& report) const {
    Knots knots(l, near, far, outside);
    const Sample a = sample(l, knots.before());
    if (std::fabs(a.value) < kZero && report(knots.before())) return;
    search_from(l, knots, a, exit, report);
  }
  // The same from the interval that `knots` has come to and begins at `a`, which was reported if it is a hit.
  template <class Report>
  void search_from(const LocalRay& l, Knots& knots, Sample a, double exit, Report&& report) const {
    for (; !knots.done(); ++knots.next) {
      const Sample b = sample(l, knots.here());
      if (std::fabs(b.value) < kZero) {
        if (report(knots.here())) return;
      } else if (std::fabs(a.value) >= kZero) {
        double t;
        if (opposite(a, b)) {
          if (report(refined(l, a, b))) return;
        } else if (a.value > 0 && grazing_entry(l, knots.before(), a, knots.here(), t)) {
          if (report(t)) return;
        }
      }
      a = b;
      if (well_inside(a)) pass_inside(l, knots, exit, a);
    }
  }
  // The same for several rays, in step as long as they take the way that most do: from a knot outside to one inside,
  // and from there to one outside again. report(lane, t).
  template <class Report>
  void search_packet(unsigned lanes, const LocalRay* locals, const double* near, const double* far,
                     const double* outside, const double* exit, Report&& report) const {
    constexpr int kCount = EllipsoidPoints::kCount;
    Knots knots[kCount];
    Sample a[kCount], b[kCount];
    Root entries[kCount], exits[kCount];
    each_lane(lanes, [&](int k) {
      knots[k] = Knots(locals[k], near[k], far[k], outside[k]);
      a[k].p = point(locals[k], knots[k].before()), b[k].p = point(locals[k], knots[k].here());
    });
    const auto go_on_alone = [&](int k) {
      search_from(locals[k], knots[k], a[k], exit[k], [&](double at) { return report(k, at); });
    };
    evaluate(a, lanes), evaluate(b, lanes);
    // Those that enter in this interval; those that are inside at its end; those that leave.
    unsigned enters = 0, within = 0, leaves = 0;
    each_lane(lanes, [&](int k) {
      const bool begins_outside = a[k].value >= kZero, begins_inside = a[k].value <= -kZero;
      if (begins_outside && b[k].value <= -kZero)
        enters |= 1u << k, within |= 1u << k, entries[k] = Root(a[k], b[k], convex());
      else if (begins_inside && b[k].value <= -kZero)
        within |= 1u << k;
      else if (begins_inside && b[k].value >= kZero)
        leaves |= 1u << k;
      else if (!(std::fabs(a[k].value) < kZero && report(k, knots[k].before())))
        go_on_alone(k);
    });
    // On to the last knot inside, where the exit is known, and to the first one outside.
    unsigned known = 0;
    each_lane(within, [&](int k) {
      a[k] = b[k];
      if (well_inside(a[k]) && exit[k] != -HUGE_VAL) known |= 1u << k;
    });
    pass_inside(known, locals, exit, knots, a);
    each_lane(within, [&](int k) {
      ++knots[k].next;
      if (knots[k].done()) known &= ~(1u << k);
      if (known >> k & 1) b[k].p = point(locals[k], knots[k].here());
    });
    evaluate(b, known);
    each_lane(known, [&](int k) { leaves |= b[k].value >= kZero ? 1u << k : 0; });
    each_lane(leaves, [&](int k) { exits[k] = Root(a[k], b[k], convex()); });
    find(entries, enters, exits, leaves);
    each_lane(within | leaves, [&](int k) {
      if ((enters >> k & 1) != 0 && report(k, length(entries[k].at - locals[k].origin))) return;
      if ((leaves >> k & 1) != 0) {
        if (report(k, length(exits[k].at - locals[k].origin))) return;
        a[k] = b[k];
        ++knots[k].next;
      }
      go_on_alone(k);
    });
  }

  static bool well_inside(const Sample& a) { return a.value < -2 * kZero; }
  // Between two points that are well inside all is, so the last knot `a` may as well be the last of all before the
  // exit.
  void pass_inside(const LocalRay& l, Knots& knots, double exit, Sample& a) const {
    const int last = knots.last_before(exit);
    if (last == knots.next) return;
    const Sample there = sample(l, knots.at[last]);
    if (well_inside(there)) knots.next = last, a = there;
  }

  // The same for several rays.
  void pass_inside(unsigned lanes, const LocalRay* locals, const double* exit, Knots* knots, Sample* at) const {
    constexpr int kCount = EllipsoidPoints::kCount;
    int last[kCount];
    Sample there[kCount];
    unsigned passes = 0;
    each_lane(lanes, [&](int k) {
      last[k] = knots[k].last_before(exit[k]);
      if (last[k] != knots[k].next) passes |= 1u << k, there[k].p = point(locals[k], knots[k].at[last[k]]);
    });
    evaluate(there, passes);
    each_lane(passes, [&](int k) {
      if (well_inside(there[k])) knots[k].next = last[k], at[k] = there[k];
    });
  }

  double refined(const LocalRay& l, const Sample& a, const Sample& b) const {
    Root root(a, b, convex());
    while (!root.take(value(root.at))) {
    }
    return length(root.at - l.origin);
  }
  // Roots of several rays: what they ask for next is asked for together.
  void find(Root* entries, unsigned enters, Root* exits, unsigned leaves) const {
    constexpr int kMost = 2 * EllipsoidPoints::kCount;
    Root* open[kMost];
    Vec3 points[kMost];
    double found[kMost];
    int count = 0;
    each_lane(enters, [&](int k) { open[count++] = &entries[k]; });
    each_lane(leaves, [&](int k) { open[count++] = &exits[k]; });
    while (count > 0) {
      for (int i = 0; i < count; ++i) points[i] = open[i]->at;
      values(points, count, found);
      const int asked = std::exchange(count, 0);
      for (int i = 0; i < asked; ++i)
        if (!open[i]->take(found[i])) open[count++] = open[i];
    }
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

  EllipsoidNorm across_, all_;          // of x and y, of that and z
  double interval_ = 2;                 // nothing grows more than this much on the way to local coordinates
  double most_inside_, least_outside_;  // of coordinates: where the formula need not be asked
  bool guarded_;
};

}  // namespace

std::unique_ptr<Shape> compile_superellipsoid(const scene::Object& object) {
  return std::make_unique<Superellipsoid>(object, *object.as<scene::Superellipsoid>());
}

}  // namespace verisim::shapes
