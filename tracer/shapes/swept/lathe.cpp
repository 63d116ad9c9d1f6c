// lathe (spec 03 4.15): a profile (radius X(w), height Y(w)) turned about the y axis.
//
// With r = dx^2 + dz^2, m = dx px + dz pz, c = px^2 + pz^2 a ray meets a segment where r (Y - py)^2 + 2 dy m (Y - py) +
// dy^2 (c - X^2) = 0. The roots are found in Bernstein form and polished on the two original equations, Y = py + dy t
// and r t^2 + 2 m t + c = X^2, which stay well-conditioned for nearly horizontal rays (where POV-Ray's roots are noisy
// or lost: section 8).
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/swept/lathe_packet.h"
#include "tracer/shapes/swept/plane_curve.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7;
constexpr double kNearlyHorizontal = 1e-5;
enum Axis { radius, height };

std::vector<CurveSegment> segments_of(const scene::Lathe& lathe) {
  std::vector<CurveSegment> segments;
  const std::vector<Vec2>& p = lathe.points;
  const std::size_t n = p.size();
  switch (lathe.spline) {
    case scene::SplineKind::linear:
      for (std::size_t i = 0; i + 1 < n; ++i) segments.push_back(CurveSegment::linear(p[i], p[i + 1]));
      break;
    case scene::SplineKind::quadratic:
      for (std::size_t i = 0; i + 2 < n; ++i) segments.push_back(CurveSegment::quadratic(p[i], p[i + 1], p[i + 2]));
      break;
    case scene::SplineKind::bezier:
      for (std::size_t i = 0; i + 3 < n; i += 4)
        segments.push_back(CurveSegment::bezier(p[i], p[i + 1], p[i + 2], p[i + 3]));
      break;
    default:
      for (std::size_t i = 0; i + 3 < n; ++i)
        segments.push_back(CurveSegment::cubic(p[i], p[i + 1], p[i + 2], p[i + 3]));
  }
  return segments;
}

// Radii and heights of the curve, or of the control points of a Bezier profile.
struct Range {
  double r_low = HUGE_VAL, r_high = 0, y_low = HUGE_VAL, y_high = -HUGE_VAL;

  explicit Range(const scene::Lathe& lathe) {
    if (lathe.spline == scene::SplineKind::bezier) {
      for (const Vec2& p : lathe.points) add(p.x, p.x, p.y, p.y);
    } else {
      for (const CurveSegment& s : segments_of(lathe)) {
        double x0, x1, y0, y1;
        s.extremes(radius, x0, x1);
        s.extremes(height, y0, y1);
        add(x0, x1, y0, y1);
      }
    }
  }
  void add(double x0, double x1, double y0, double y1) {
    r_low = std::min(r_low, x0), r_high = std::max({r_high, std::fabs(x0), std::fabs(x1)});
    y_low = std::min(y_low, y0), y_high = std::max(y_high, y1);
  }
};

class Lathe final : public SearchPrimitive<Lathe> {
 public:
  Lathe(const scene::Object& description, const scene::Lathe& lathe)
      : SearchPrimitive(description, {lathe_box(lathe)}), range_(lathe) {
    for (const CurveSegment& s : segments_of(lathe)) {
      Segment segment{s, 0, 0};
      s.extremes(height, segment.y_low, segment.y_high);
      double x0, x1;
      s.extremes(radius, x0, x1);
      const double least = x0 <= 0 && x1 >= 0 ? 0 : std::min(std::fabs(x0), std::fabs(x1)),
                   most = std::max(std::fabs(x0), std::fabs(x1));
      const std::size_t lane = segments_.size() % 8;
      if (lane == 0) {
        blocks_.emplace_back();
        std::fill_n(blocks_.back().y_low, 8, HUGE_VAL), std::fill_n(blocks_.back().y_high, 8, -HUGE_VAL);
      }
      EightSegments& block = blocks_.back();
      block.y_low[lane] = segment.y_low, block.y_high[lane] = segment.y_high, block.low2[lane] = least * least,
      block.high2[lane] = most * most;
      segments_.push_back(segment);
    }
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    const Vec3 &p = l.origin, &d = l.direction;
    const double r = d.x * d.x + d.z * d.z, m = d.x * p.x + d.z * p.z, c = p.x * p.x + p.z * p.z;
    // The interval inside the outermost cylinder, and the heights it passes.
    double near = -HUGE_VAL, far = HUGE_VAL;
    const double outer2 = this->outer2();
    if (r > 1e-20) {
      const double discriminant = m * m - r * (c - outer2);
      if (!(discriminant >= 0)) return;
      const double root = std::sqrt(discriminant);
      near = (-m - root) / r, far = (-m + root) / r;
      if (far < 0) return;
    } else if (!(c <= outer2)) {
      return;
    }
    const double doubt = 1e-7 * (range_.r_high + std::sqrt(c));
    near = std::max({near, 0.0, sink.lower() * l.scale - doubt}), far = std::min(far, sink.upper() * l.scale + doubt);
    if (near > far) return;
    const LathePassage passage = this->passage(l, r, m, c, near, far);
    const Solver solver{l, r, m, c};
    for (std::size_t block = 0; block < blocks_.size(); ++block)
      for (unsigned met = lathe_kernels().along(blocks_[block], passage); met != 0; met &= met - 1) {
        const std::size_t i = 8 * block + static_cast<std::size_t>(std::countr_zero(met));
        if (i >= segments_.size()) break;  // of numbers that are none
        solver.segment(segments_[i].curve, [&](double w, double t) { add(ray, t / l.scale, i, w, sink); });
      }
  }

  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.active;
    if (admitted == 0) return 0;
    LathePacket packet;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, packet.rays);
    const unsigned met = lathe_kernels().begin(outer2(), admitted, packet);
    LocalRay locals[RayPacket::kCount];
    std::optional<NearestHit> sinks[RayPacket::kCount];
    unsigned found = 0, horizontal = 0;
    each_lane(met, [&](int k) {
      locals[k] = local(rays.at(k));
      sinks[k].emplace(*this, guards(), t_min, t_max[k], hit_of(k), any);
      horizontal |= std::fabs(packet.rays.dy[k]) < kNearlyHorizontal ? 1u << k : 0;
    });
    unsigned open = met;
    for (std::size_t i = 0; i < segments_.size() && open != 0; ++i) {
      const Segment& s = segments_[i];
      const unsigned beside = open & lathe_kernels().beside(s.y_low, s.y_high, slack(), packet);
      if (beside == 0) continue;
      const auto report = [&](int k, double w, double t) {
        add(rays.at(k), t / locals[k].scale, i, w, *sinks[k]);
        if (any && sinks[k]->found()) open &= ~(1u << k);
      };
      each_lane(beside & horizontal, [&](int k) {
        Solver{locals[k], packet.r[k], packet.m[k], packet.c[k]}.segment(s.curve,
                                                                         [&](double w, double t) { report(k, w, t); });
      });
      if ((beside & ~horizontal) != 0) follow(s.curve, beside & ~horizontal, packet, locals, report, open);
    }
    each_lane(met, [&](int k) { found |= sinks[k]->found() ? 1u << k : 0; });
    return found;
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    if (p.y < range_.y_low || p.y > range_.y_high) return false;
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (rho < range_.r_low || rho > range_.r_high) return false;
    int count = 0;
    for (const Segment& s : segments_) {
      if (p.y < s.y_low || p.y > s.y_high) continue;
      double roots[kMaxBernsteinDegree];
      const int n = s.curve.solve(height, p.y, roots);
      for (int i = 0; i < n; ++i) count += s.curve.value(radius, roots[i]) >= rho;
    }
    return count & 1;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 p = local(hit.point);
    const double rho2 = p.x * p.x + p.z * p.z;
    if (!(rho2 > kEpsilon)) return world_normal({0, 1, 0});
    const CurveSegment& s = segments_[static_cast<std::size_t>(hit.part)].curve;
    const double dy = s.slope(height, hit.u);
    return world_normal({dy * p.x, -s.slope(radius, hit.u) * std::sqrt(rho2), dy * p.z});
  }

  Vec2 uv(const Hit& hit) const override {
    const Vec3 p = local(hit.point);
    return {turn_fraction(p.x, p.z), std::min(1.0, (hit.part + hit.u) / static_cast<double>(segments_.size()))};
  }

 private:
  struct Segment {
    CurveSegment curve;
    double y_low, y_high;  // its heights
  };
  // Where a ray is between two distances, for the kernel.
  LathePassage passage(const LocalRay& l, double r, double m, double c, double near, double far) const {
    constexpr double kSteep = 1e-3;  // others know their roots less well
    double y0 = l.origin.y + l.direction.y * near, y1 = l.origin.y + l.direction.y * far;
    if (!(std::fabs(l.direction.y) > 0)) y0 = y1 = l.origin.y;
    if (y0 > y1) std::swap(y0, y1);
    LathePassage p{y0, y1, slack(), r, m, c, l.origin.y, near, far};
    if (std::fabs(l.direction.y) > kSteep)
      p.inverse = 1 / l.direction.y, p.turn = r > 1e-20 ? -m / r : 0, p.doubt = 1e-5 * outer2() + 1e-9 * (c + m * m);
    return p;
  }

  double outer2() const { return range_.r_high * range_.r_high * (1 + 1e-9); }
  double slack() const { return 1e-9 * (range_.y_high - range_.y_low); }
  template <class Sink>
  static void add(const Ray& ray, double depth, std::size_t segment, double w, Sink& sink) {
    if (depth > kNearest && depth < kFarthest)
      sink.add(
          depth, [&] { return ray.origin + depth * ray.direction; }, static_cast<std::int32_t>(segment), w);
  }

  // The roots of a segment for several rays; those that are no longer open are left alone.
  template <class Report>
  static void follow(const CurveSegment& curve, unsigned rays, const LathePacket& packet, const LocalRay* locals,
                     Report&& report, const unsigned& open) {
    RootPacket roots;
    lathe_kernels().follow(curve, packet, roots);
    unsigned more = bernstein_kernels().begin(2 * curve.degree, rays, roots);
    while (more != 0) {
      more = bernstein_kernels().next(2 * curve.degree, more, roots);
      each_lane(more, [&](int k) {
        const LocalRay& l = locals[k];
        double w = roots.root[k], t = (curve.value(height, w) - l.origin.y) / l.direction.y;
        Solver{l, packet.r[k], packet.m[k], packet.c[k]}.polish(curve, w, t);
        report(k, w, t);
      });
      more &= open;
    }
  }

  struct Solver {
    const LocalRay& l;
    double r, m, c;

    template <class Report>
    void segment(const CurveSegment& s, Report&& report) const {
      const double py = l.origin.y, dy = l.direction.y;
      double roots[kMaxBernsteinDegree];
      if (std::fabs(dy) < kNearlyHorizontal) {
        // The height hardly changes within the body: start from where the profile has the height of the middle of the
        // chord.
        const double middle = r > 0 ? -m / r : 0;
        const int n = s.solve(height, py + dy * middle, roots);
        for (int i = 0; i < n; ++i) {
          const double x = s.value(radius, roots[i]), discriminant = m * m - r * (c - x * x);
          if (!(discriminant >= 0) || !(r > 0)) continue;
          for (const double sign : {-1.0, 1.0}) {
            double w = roots[i], t = (-m + sign * std::sqrt(discriminant)) / r;
            polish(s, w, t);
            if (w >= -1e-9 && w <= 1 + 1e-9) report(std::clamp(w, 0.0, 1.0), t);
          }
        }
        return;
      }
      const int k = s.degree;
      double y[4], power[7] = {};
      for (int i = 0; i <= k; ++i) y[i] = s.c[static_cast<std::size_t>(i)].y;
      y[0] -= py;
      for (int i = 0; i <= k; ++i) {
        power[i] += 2 * dy * m * y[i];
        for (int j = 0; j <= k; ++j)
          power[i + j] +=
              r * y[i] * y[j] - dy * dy * s.c[static_cast<std::size_t>(i)].x * s.c[static_cast<std::size_t>(j)].x;
      }
      power[0] += dy * dy * c;
      const int n = k == 1   ? bernstein_roots<2>(power, 0, 1, roots)
                    : k == 2 ? bernstein_roots<4>(power, 0, 1, roots)
                             : bernstein_roots<6>(power, 0, 1, roots);
      for (int i = 0; i < n; ++i) {
        double w = roots[i], t = (s.value(height, w) - py) / dy;
        polish(s, w, t);
        report(w, t);
      }
    }

    // Newton's method on both equations; keeps the start where it does not converge.
    void polish(const CurveSegment& s, double& w, double& t) const {
      double w1 = w, t1 = t;
      const auto residual = [&](double ww, double tt, double& f, double& g) {
        const double x = s.value(radius, ww);
        f = s.value(height, ww) - l.origin.y - l.direction.y * tt;
        g = (r * tt + 2 * m) * tt + c - x * x;
      };
      double f, g;
      residual(w1, t1, f, g);
      for (int step = 0; step < 4; ++step) {
        const double fw = s.slope(height, w1), ft = -l.direction.y;
        const double gw = -2 * s.value(radius, w1) * s.slope(radius, w1), gt = 2 * (r * t1 + m);
        const double determinant = fw * gt - ft * gw;
        if (determinant == 0) return;
        const double dw = (f * gt - ft * g) / determinant, dt = (fw * g - f * gw) / determinant;
        w1 -= dw, t1 -= dt;
        residual(w1, t1, f, g);
        if (std::fabs(dw) < 1e-15) break;
      }
      if (std::fabs(w1 - w) < 0.1 && std::isfinite(t1) && w1 > -1e-6 && w1 < 1 + 1e-6)
        w = std::clamp(w1, 0.0, 1.0), t = t1;
    }
  };

  std::vector<Segment> segments_;
  std::vector<EightSegments> blocks_;
  Range range_;
};

}  // namespace

Box3 lathe_box(const scene::Lathe& lathe) {
  const Range range(lathe);
  return {Vec3(-range.r_high, range.y_low, -range.r_high), Vec3(range.r_high, range.y_high, range.r_high)};
}

std::unique_ptr<Shape> compile_lathe(const scene::Object& object) {
  return std::make_unique<Lathe>(object, **object.as<std::shared_ptr<const scene::Lathe>>());
}

}  // namespace verisim::shapes
