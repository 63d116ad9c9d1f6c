// sor, surface of revolution (spec 03 4.16): the squared radius is a cubic of the height between two points.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/swept/sor_lanes.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7, kSmallestCap2 = 1e-4;
constexpr std::int32_t kBase = -1, kCap = -2;

using Segment = SorSegment;

// The cubic through (y0, f0) and (y1, f1) with slopes s0, s1, in powers of y.
Segment hermite(double y0, double y1, double f0, double f1, double s0, double s1) {
  const double h = y1 - y0, mean = (f1 - f0) / h;
  const double a = (s0 + s1 - 2 * mean) / (h * h), b = (3 * mean - 2 * s0 - s1) / h;  // of (y - y0)^3 and (y - y0)^2
  Segment s{y0, y1, {f0 - y0 * (s0 - y0 * (b - y0 * a)), s0 - y0 * (2 * b - 3 * y0 * a), b - 3 * y0 * a, a}, 0, 0};
  for (double& v : s.c)
    if (std::fabs(v) < kEpsilon) v = 0;
  return s;
}

// Sets the bounds of a segment's squared radius.
void measure(Segment& s) {
  s.least2 = std::min(s.radius2(s.low), s.radius2(s.high)), s.most2 = std::max(s.radius2(s.low), s.radius2(s.high));
  const double a = 3 * s.c[3], b = 2 * s.c[2], c = s.c[1];
  double roots[2];
  int n = 0;
  if (a != 0) {
    const double discriminant = b * b - 4 * a * c;
    if (discriminant >= 0)
      for (const double sign : {-1.0, 1.0}) roots[n++] = (-b + sign * std::sqrt(discriminant)) / (2 * a);
  } else if (b != 0) {
    roots[n++] = -c / b;
  }
  for (int i = 0; i < n; ++i)
    if (roots[i] > s.low && roots[i] < s.high)
      s.least2 = std::min(s.least2, s.radius2(roots[i])), s.most2 = std::max(s.most2, s.radius2(roots[i]));
}

std::vector<Segment> segments_of(const scene::Sor& sor) {
  std::vector<Segment> segments;
  const std::vector<Vec2>& p = sor.points;
  for (std::size_t i = 1; i + 2 < p.size(); ++i) {
    const double s0 = 2 * p[i].x * (p[i + 1].x - p[i - 1].x) / (p[i + 1].y - p[i - 1].y);
    const double s1 = 2 * p[i + 1].x * (p[i + 2].x - p[i].x) / (p[i + 2].y - p[i].y);
    segments.push_back(hermite(p[i].y, p[i + 1].y, p[i].x * p[i].x, p[i + 1].x * p[i + 1].x, s0, s1));
    measure(segments.back());
  }
  return segments;
}

double largest_radius2(const std::vector<Segment>& segments) {
  double largest = 0;
  for (const Segment& s : segments) largest = std::max(largest, s.most2);
  return largest;
}

class Sor final : public Primitive<Sor> {
 public:
  Sor(const scene::Object& description, const scene::Sor& sor)
      : Primitive(description, {sor_box(sor)}), segments_(segments_of(sor)), outer2_(largest_radius2(segments_)) {
    if (segments_.empty()) return;
    const double slack = 1e-9 * outer2_ + 1e-12;
    for (Segment& s : segments_) s.least2 -= slack, s.most2 += slack;
    base_ = sor.points[1];
    cap_ = sor.points[sor.points.size() - 2];
    has_base_ = !sor.open && base_.x * base_.x > kSmallestCap2;
    has_cap_ = !sor.open && cap_.x * cap_.x > kSmallestCap2;
  }

  template <class Sink>
  void crossings(const Ray& ray, Sink& sink) const {
    if (segments_.empty()) return;
    const LocalRay l = local(ray);
    const Vec3 &p = l.origin, &d = l.direction;
    const auto report = [&](double t, std::int32_t part) { return add(ray, t / l.scale, part, sink); };
    const double r = d.x * d.x + d.z * d.z, m = d.x * p.x + d.z * p.z, c = p.x * p.x + p.z * p.z;
    double near = 0, far = kFarthest * l.scale;
    const double around2 = this->around2();
    if (r > 1e-20) {
      const double discriminant = m * m - r * (c - around2);
      if (!(discriminant >= 0)) return;
      const double root = std::sqrt(discriminant);
      near = std::max(near, (-m - root) / r), far = std::min(far, (-m + root) / r);
      if (near > far) return;
    } else if (!(c <= around2)) {
      return;
    }
    each_end(l, report);
    // Only the nearest hit is wanted: segments from near to far, until one is hit.
    const bool downwards = Sink::kNearest && d.y < 0;
    for (std::size_t step = 0; step < segments_.size(); ++step) {
      const std::size_t i = downwards ? segments_.size() - 1 - step : step;
      const Segment& s = segments_[i];
      double from = near, to = far;
      if (d.y == 0) {
        if (p.y < s.low || p.y > s.high) continue;
      } else {
        double a = (s.low - p.y) / d.y, b = (s.high - p.y) / d.y;
        if (a > b) std::swap(a, b);
        from = std::max(from, a), to = std::min(to, b);
      }
      if (!(from <= to)) continue;
      if (Sink::kNearest && from > sink.upper() * l.scale) return;
      // The distance from the axis against the radii of this segment.
      const double middle = r > 0 ? std::clamp(-m / r, from, to) : from;
      const auto rho2 = [&](double t) { return (r * t + 2 * m) * t + c; };
      if (rho2(middle) > s.most2 || std::max(rho2(from), rho2(to)) < s.least2) continue;
      // radius^2(py + dy t) - (r t^2 + 2 m t + c), in powers of t - from.
      const Vec3 q = p + from * d;
      const double y = q.y, dy = d.y;
      const double power[4] = {s.radius2(y) - (q.x * q.x + q.z * q.z), s.slope(y) * dy - 2 * (d.x * q.x + d.z * q.z),
                               (3 * s.c[3] * y + s.c[2]) * dy * dy - r, s.c[3] * dy * dy * dy};
      double roots[3];
      const int n = bernstein_roots<3>(power, 0, to - from, roots);
      bool accepted = false;
      for (int k = 0; k < n; ++k) accepted |= report(from + roots[k], static_cast<std::int32_t>(i));
      if (Sink::kNearest && accepted) return;
    }
  }

  unsigned intersect_lanes(const RayLanes& rays, const accel::EntryPoints*, RayKind, double t_min, const double* t_max,
                           Hit* hits) const override {
    return nearest_of_lanes(
        rays, t_min, t_max, [&](int k) -> Hit& { return hits[k]; }, false);
  }
  unsigned occludes_lanes(const RayLanes& rays, const accel::EntryPoints*, double t_min,
                          const double* t_max) const override {
    Hit hit;
    return nearest_of_lanes(
        rays, t_min, t_max, [&](int) -> Hit& { return hit; }, true);
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    const double rho2 = p.x * p.x + p.z * p.z;
    for (const Segment& s : segments_)
      if (p.y >= s.low && p.y <= s.high) return rho2 <= s.radius2(p.y);
    return false;
  }

  Vec3 raw_normal(const Hit& hit) const {
    if (hit.part == kBase) return world_normal({0, -1, 0});
    if (hit.part == kCap) return world_normal({0, 1, 0});
    const Vec3 p = local(hit.point);
    const Vec3 n(p.x, -0.5 * segments_[static_cast<std::size_t>(hit.part)].slope(p.y), p.z);
    return n == Vec3(0) ? Vec3(1, 0, 0) : world_normal(n);
  }

  Vec2 uv(const Hit& hit) const override {
    const Vec3 p = local(hit.point);
    const double u = turn_fraction(p.x, p.z), rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (hit.part == kBase) return {u, rho / base_.x - 1};
    if (hit.part == kCap) return {u, 2 - rho / cap_.x};
    const Segment& s = segments_[static_cast<std::size_t>(hit.part)];
    return {u, (hit.part + (p.y - s.low) / (s.high - s.low)) / static_cast<double>(segments_.size())};
  }

 private:
  double around2() const { return outer2_ * (1 + 1e-9) + 1e-12; }

  template <class Sink>
  static bool add(const Ray& ray, double depth, std::int32_t part, Sink& sink) {
    return depth > kNearest && depth < kFarthest &&
           sink.add(
               depth, [&] { return ray.origin + depth * ray.direction; }, part);
  }
  template <class Report>
  void each_end(const LocalRay& l, Report&& report) const {
    const Vec3 &p = l.origin, &d = l.direction;
    if (!(std::fabs(d.y) > kEpsilon)) return;
    const auto disc = [&](const Vec2& rim, std::int32_t part) {
      const double t = (rim.y - p.y) / d.y, x = p.x + t * d.x, z = p.z + t * d.z;
      if (x * x + z * z <= rim.x * rim.x) report(t, part);
    };
    if (has_base_) disc(base_, kBase);
    if (has_cap_) disc(cap_, kCap);
  }

  template <class HitOf>
  unsigned nearest_of_lanes(const RayLanes& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.asked;
    if (admitted == 0 || segments_.empty()) return 0;
    SorLanes lanes;
    lane_kernels().local(has_matrix() ? &matrix() : nullptr, rays, lanes.rays);
    const unsigned met = sor_kernels().begin(around2(), kFarthest, admitted, lanes);
    std::optional<NearestHit> sinks[RayLanes::kCount];
    unsigned falling = 0;
    each_lane(met, [&](int k) {
      sinks[k].emplace(*this, guards(), t_min, t_max[k], hit_of(k), any);
      if (has_base_ || has_cap_) {
        const Ray ray = rays.at(k);
        const LocalRay l = local(ray);
        each_end(l, [&](double t, std::int32_t part) { return add(ray, t / l.scale, part, *sinks[k]); });
      }
      falling |= lanes.rays.dy[k] < 0 ? 1u << k : 0;
      lanes.upper[k] = sinks[k]->upper();
    });
    follow(rays, met & ~falling, false, lanes, sinks);
    follow(rays, met & falling, true, lanes, sinks);
    unsigned found = 0;
    each_lane(met, [&](int k) { found |= sinks[k]->found() ? 1u << k : 0; });
    return found;
  }
  // Segments from near to far, for each lane until it is hit.
  void follow(const RayLanes& rays, unsigned open, bool downwards, SorLanes& lanes,
              std::optional<NearestHit>* sinks) const {
    RootLanes roots;
    for (std::size_t step = 0; step < segments_.size() && open != 0; ++step) {
      const std::size_t i = downwards ? segments_.size() - 1 - step : step;
      unsigned curved = sor_kernels().enter(segments_[i], open, lanes, roots);
      if (curved != 0) curved = bernstein_kernels().begin(3, curved, roots);
      while (curved != 0) {
        curved &= bernstein_kernels().next(3, curved, roots);
        each_lane(curved, [&](int k) {
          const double t = lanes.from[k] + roots.root[k];
          if (add(rays.at(k), t / lanes.rays.scale[k], static_cast<std::int32_t>(i), *sinks[k]))
            curved &= ~(1u << k), open &= ~(1u << k);
        });
      }
    }
  }

  std::vector<Segment> segments_;
  double outer2_;
  Vec2 base_{0, 0}, cap_{0, 0};  // radius and height of the ends
  bool has_base_ = false, has_cap_ = false;
};

}  // namespace

Box3 sor_box(const scene::Sor& sor) {
  const auto segments = segments_of(sor);
  if (segments.empty()) return {};
  const double radius = std::sqrt(largest_radius2(segments));
  return {Vec3(-radius, segments.front().low, -radius), Vec3(radius, segments.back().high, radius)};
}

std::unique_ptr<Shape> compile_sor(const scene::Object& object) {
  return std::make_unique<Sor>(object, **object.as<std::shared_ptr<const scene::Sor>>());
}

}  // namespace verisim::shapes
