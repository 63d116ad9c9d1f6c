// POV-Ray's search for the surface of a superellipsoid along a ray (spec 03 4.12), for one ray and for several in step.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracer/shapes/algebraic/superellipsoid_packet.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

class SuperellipsoidSearch {
 public:
  static constexpr double kZero = 1e-10;  // what counts as a zero of the value

  SuperellipsoidSearch(const EllipsoidNorm& across, const EllipsoidNorm& all) : across_(across), all_(all) {}
  const EllipsoidNorm& across() const { return across_; }  // of x and y
  const EllipsoidNorm& all() const { return all_; }        // of that and z

  double value(const Vec3& p) const { return all_(across_(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)) - 1; }
  // With exponents of at least 1 the nested norms are convex: a ray enters once and leaves once, and Newton's method
  // from outside goes straight to each.
  bool convex() const { return across_.exponent >= 1 && all_.exponent >= 1; }

  // POV-Ray's search from `near` to `far`, step by step, because it stops where the value is within 1e-10 of zero: its
  // steps decide the last bits of hits, and which hits are lost. Up to `outside` there is none; near `exit` a convex
  // one is left (-HUGE_VAL: unknown). report(t) says whether it may stop.
  template <class Report>
  void along(const LocalRay& l, double near, double far, double outside, double exit, Report&& report) const {
    Knots knots(l, near, far, outside);
    const Sample a = sample(l, knots.before());
    if (std::fabs(a.value) < kZero && report(knots.before())) return;
    along_from(l, knots, a, exit, report);
  }
  // The same for several rays, in step as long as they take the way that most do: from a knot outside to one inside,
  // and from there to one outside again. report(lane, t).
  template <class Report>
  void along_packet(unsigned lanes, const LocalRay* locals, const double* near, const double* far,
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
      along_from(locals[k], knots[k], a[k], exit[k], [&](double at) { return report(k, at); });
    };
    evaluate(a, lanes), evaluate(b, lanes);
    // Those that enter in this interval; those that are inside at its end; those that leave.
    unsigned enters = 0, within = 0, leaves = 0;
    each_lane(lanes, [&](int k) {
      const bool begins_outside = a[k].value >= kZero, begins_inside = well_inside(a[k]);
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

 private:
  static constexpr int kMaxSteps = 20;

  // A point of a ray in the shape's own space, and the value there.
  struct Sample {
    Vec3 p;
    double value;
  };
  static bool opposite(const Sample& a, const Sample& b) { return (a.value < 0) != (b.value < 0); }

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

  // The same from the interval that `knots` has come to and begins at `a`, which was reported if it is a hit.
  template <class Report>
  void along_from(const LocalRay& l, Knots& knots, Sample a, double exit, Report&& report) const {
    for (; !knots.done(); ++knots.next) {
      const Sample b = sample(l, knots.here());
      if (std::fabs(b.value) < kZero) {
        if (report(knots.here())) return;
      } else {
        double t;
        if (opposite(a, b)) {
          if (report(std::fabs(a.value) < kZero ? length(a.p - l.origin) : refined(l, a, b))) return;
        } else if (!opposite(a, b) && !well_inside(a) && grazing_entry(l, knots.before(), a, knots.here(), t)) {
          if (report(t)) return;
        }
      }
      a = b;
      if (well_inside(a)) pass_inside(l, knots, exit, a);
    }
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
    constexpr int kMax = 2 * EllipsoidPoints::kCount;
    Root* open[kMax];
    Vec3 points[kMax];
    double found[kMax];
    int count = 0;
    each_lane(enters, [&](int k) { open[count++] = &entries[k]; });
    each_lane(leaves, [&](int k) { open[count++] = &exits[k]; });
    while (count > 0) {
      for (int i = 0; i < count; ++i) points[i] = open[i]->at;
      values(points, count, found);
      const int active = std::exchange(count, 0);
      for (int i = 0; i < active; ++i)
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
      if (a.value < 0) return false;
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

  EllipsoidNorm across_, all_;
};

}  // namespace verisim::shapes
