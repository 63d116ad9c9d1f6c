// The march of one ray through a julia_fractal (spec 04 section 8): steps by estimates of the distance, then bisection.
// The hit depends on the whole sequence of steps, so it is followed exactly.
#pragma once

#include "tracer/shapes/julia/julia_iteration.h"

namespace verisim::shapes::julia {

class March {
 public:
  explicit March(const Iteration& iteration) : iteration_(iteration), field_(iteration.field()) {}

  // The march from `begin` to `end`, with no intersection behind `last`. found(depth of an intersection, its point)
  // says whether to stop. Where it does not, the march goes on behind the coarse step, but counts distances from the
  // intersection, as POV-Ray does: those of later hits, not their points, fall short, and so does the end.
  template <class Found>
  void walk(Orbit& orbit, const Ray& r, double t, double end, double last, Found&& found) const {
    double estimate, uncounted = 0;
    Vec3 p = r.origin + t * r.direction;
    bool in = march(orbit, p, r.direction, estimate);
    if (in) {
      t += 2 * kFine, p += 2 * kFine * r.direction;
      if (t > end) return;
      in = march(orbit, p, r.direction, estimate);
    }
    const auto crossed = [&](const Reached& base, double step, bool now) {
      // The step is taken back from the distance: where it passed a power of two a last place is lost.
      const Reached hit = bisect(orbit, {t - step, base.point}, r.direction, step, in);
      in = now;
      // Of a crossing back in the same place the first is seen: a last place is added.
      const double counted = std::nextafter(hit.depth, end);
      uncounted += t - counted, t = counted;
      return found(hit.depth, hit.point);
    };
    // What the march leaves in the orbit counts. Points ahead leave nothing there, but of a step with a crossing one
    // end survives all iterations, and what was before both is forgotten.
    bool left = true;  // whether the point at t has left its iterates
    const auto leave = [&](const Vec3& point) {
      if (!is_power(field_.kind)) iteration_.iterate(orbit, iteration_.start(point));
    };
    while (t + uncounted <= last) {
      if (estimate <= field_.precision) {
        // Where the smallest step is due it mostly is so for many steps: look ahead.
        double ahead[kLanes], estimates[kLanes], at = t;
        Points points;
        Vec3 next_point = p;
        for (int k = 0; k < kLanes; ++k) {
          ahead[k] = at += field_.precision;
          points.set(k, next_point += field_.precision * r.direction);
        }
        if (!(ahead[0] <= end)) return;
        const unsigned inside = kernels().march(field_, points, r.direction, estimates);
        for (int k = 0; k < kLanes; ++k) {
          if (!(ahead[k] <= end)) return;
          const Reached base{t, p};
          t = ahead[k], p = points[k], estimate = estimates[k];
          const bool now = inside >> k & 1;
          if (now != in) {
            if (!left) leave(base.point);
            leave(p), left = true;
            if (crossed(base, field_.precision, now)) return;
            break;  // distances ahead are others now
          }
          left = false;
          if (estimate > field_.precision) break;
        }
        continue;
      }
      const double step = std::max(estimate, field_.precision);
      const Reached base{t, p};
      t += step, p += step * r.direction;
      if (!(t <= end)) return;
      const bool now = march(orbit, p, r.direction, estimate), base_left = std::exchange(left, true);
      if (now == in) continue;
      if (!base_left) leave(base.point), leave(p);
      if (crossed(base, step, now)) return;
    }
  }

 private:
  // Where the march is: the point is carried along, step by step, and its bits are not those of the distance.
  struct Reached {
    double depth;
    Vec3 point;
    Reached onward(double by, const Vec3& direction) const { return {depth + by, point + by * direction}; }
  };

  // The intersection reported for a change of state between base and base + step; `in` is the state at base.
  Reached bisect(Orbit& orbit, const Reached& base, const Vec3& direction, double step, bool in) const {
    Reached low = base;
    double width = step;
    if (!is_power(field_.kind)) {
      while (width > kFine) {
        width /= 2;
        const Reached middle = low.onward(width, direction);
        if ((iteration_.iterate(orbit, iteration_.start_of_inside(middle.point)) == 0) == in) low = middle;
      }
      return in ? low : low.onward(width, direction);
    }
    while (width > kFine) {
      const unsigned inside = kernels().halvings(field_, low.point, direction, width);
      for (unsigned n = 0; n < 15 && width > kFine;) {
        width /= 2;
        const bool same = (inside >> n & 1) == static_cast<unsigned>(in);
        if (same) low = low.onward(width, direction);
        n = 2 * n + (same ? 2 : 1);
      }
    }
    return in ? low : low.onward(width, direction);
  }

  // Inside at the point, and how far the ray may go from there.
  bool march(Orbit& orbit, const Vec3& point, const Vec3& direction, double& estimate) const {
    const Number h0 = iteration_.start(point);
    if (field_.kind == Kind::quaternion_square) return march_quaternion<Kind::quaternion_square>(h0, estimate);
    if (field_.kind == Kind::quaternion_cube) return march_quaternion<Kind::quaternion_cube>(h0, estimate);
    const int escaped = iteration_.iterate(orbit, h0);
    estimate = field_.precision;
    if (escaped == 0) return true;
    const Number& h = orbit[escaped - 1];
    const double q =
        field_.kind == Kind::hypercomplex_square ? norm2<Kind::hypercomplex_square>(h) : norm2<Kind::function>(h);
    const double slope = dot(iteration_.hypercomplex_normal(orbit, escaped - 1), direction);
    if (slope_tells(slope, q, field_.precision)) estimate = q / (-2 * slope);
    return false;
  }

  template <Kind K>
  bool march_quaternion(const Number& h0, double& estimate) const {
    Number h = h0;
    double product2 = 1, power = 1;
    for (int i = 1; i <= field_.iterations; ++i) {
      const double q = norm2<K>(h);
      product2 *= q;
      power *= K == Kind::quaternion_cube ? 1.0 / 3 : 1.0 / 2;
      if (q > field_.escape) {
        // ln q <= q - 1: most of the smallest steps need neither logarithm nor the product itself, for whose last bits
        // that of the lengths does not stand.
        estimate = power * std::sqrt(q / product2) * (q - 1) > field_.precision
                       ? power * std::sqrt(q / product_norm2<K>(h0, i)) * std::log(q)
                       : field_.precision;
        return false;
      }
      if (i < field_.iterations) h = iteration_.template next<K>(h);
    }
    estimate = field_.precision;
    return true;
  }
  // |h(count-1) ... h1 h0|^2
  template <Kind K>
  double product_norm2(Number h, int count) const {
    Number m = h;
    for (int i = 1; i < count; ++i) {
      h = iteration_.template next<K>(h);
      m = quaternion_product<K>(h, m);
    }
    return norm2_of_product(m);
  }

  const Iteration& iteration_;
  const Field& field_;
};

}  // namespace verisim::shapes::julia
