// sor, surface of revolution (spec 03 4.16): the squared radius is a cubic of the height between two points.
//
// POV-Ray finds the cubics by inverting a matrix of powers of the heights, and the hits by a closed form. Both lose
// digits, for thin segments and for nearly level rays, and what they show then is part of the shape (spec 08 F): every
// operation here is done in POV-Ray's order.
#include <algorithm>
#include <cmath>

#include "tracer/math/matrix_inverse.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/first_hit.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

constexpr double kStart = 1e-10, kNearest = 1e-4, kFarthest = 1e7, kSmallestCap2 = 1e-4;
constexpr std::int32_t kBase = -1, kCap = -2;

struct Segment {
  double low, high;              // heights
  double a, b, c, d;             // radius^2 = ((a y + b) y + c) y + d
  double least2 = 0, most2 = 0;  // squared radii of the annulus that a ray must come through
  double radius2(double y) const { return ((a * y + b) * y + c) * y + d; }
  double slope(double y) const { return (3 * a * y + 2 * b) * y + c; }
};

// The cubic through (y0, f0) and (y1, f1) with slopes s0, s1.
Segment segment(double y0, double y1, double f0, double f1, double s0, double s1) {
  const Mat4 powers(y0 * y0 * y0, y0 * y0, y0, 1,  //
                    y1 * y1 * y1, y1 * y1, y1, 1,  //
                    3 * y0 * y0, 2 * y0, 1, 0,     //
                    3 * y1 * y1, 2 * y1, 1, 0);
  const Mat4 solved = cofactor_inverse(powers).matrix;
  const auto coefficient = [&](int i) {
    const double* const row = solved[i];
    const double value = f0 * row[0] + f1 * row[1] + s0 * row[2] + s1 * row[3];
    return std::fabs(value) < kEpsilon ? 0 : value;
  };
  return {y0, y1, coefficient(0), coefficient(1), coefficient(2), coefficient(3)};
}

// The annulus is that of the points and of the extremes between them: what the cubic itself is at its ends does not
// count. POV-Ray takes roots of the squares there. Of a negative one, which a point on the axis may have by rounding,
// it is NaN: the first extreme leaves no annulus then, so that no ray finds the segment, and the second none of
// its own (spec 08 F).
void find_annulus(Segment& s, double radius0, double radius1) {
  s.least2 = std::min(radius0, radius1), s.most2 = std::max(radius0, radius1);
  s.least2 *= s.least2, s.most2 *= s.most2;
  const double slope[3] = {3 * s.a, 2 * s.b, s.c};
  double roots[2];
  const int n = solve_polynomial(2, slope, roots);
  for (int i = 0; i < n; ++i) {
    if (!(roots[i] > s.low && roots[i] <= s.high)) continue;
    const double radius2 = s.radius2(roots[i]);
    if (radius2 < 0) {
      if (i == 1) continue;
      s.least2 = HUGE_VAL, s.most2 = -HUGE_VAL;
      return;
    }
    s.least2 = std::min(s.least2, radius2), s.most2 = std::max(s.most2, radius2);
  }
}

std::vector<Segment> segments_of(const scene::Sor& sor) {
  std::vector<Segment> segments;
  const std::vector<Vec2>& p = sor.points;
  for (std::size_t i = 1; i + 2 < p.size(); ++i) {
    const auto slope = [&p](std::size_t k) {
      return 2 * p[k].x * ((p[k + 1].x - p[k - 1].x) / (p[k + 1].y - p[k - 1].y));
    };
    segments.push_back(segment(p[i].y, p[i + 1].y, p[i].x * p[i].x, p[i + 1].x * p[i + 1].x, slope(i), slope(i + 1)));
    find_annulus(segments.back(), p[i].x, p[i + 1].x);
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
      : Primitive(description, {sor_box(sor)}), segments_(segments_of(sor)), sturm_(description.sturm) {
    if (segments_.empty()) return;
    outer2_ = largest_radius2(segments_);
    slack_ = 1e-9 * outer2_ + 1e-12;
    outer2_ += slack_;
    for (Segment& s : segments_) s.least2 -= slack_;
    const auto end = [&](double y, const Segment& s) { return End{y, s.radius2(y)}; };
    base_ = end(segments_.front().low, segments_.front()), cap_ = end(segments_.back().high, segments_.back());
    has_base_ = !sor.open && base_.radius2 > kSmallestCap2;
    has_cap_ = !sor.open && cap_.radius2 > kSmallestCap2;
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    if (segments_.empty()) return;
    const LocalRay l = unit_local(ray);
    each_end(l, [&](double t, std::int32_t part) { add(ray, t / l.scale, part, sink); });
    if (keeps_first_hit(sink))  // of the curve; the ends count by themselves
      add_first_hit(*this, guards(), sink, [&](auto& hit, double, double to) { search(ray, l, hit, to); });
    else
      search(ray, l, sink, kFarthest);
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    const double rho2 = p.x * p.x + p.z * p.z;
    for (const Segment& s : segments_)
      if (p.y >= s.low && p.y <= s.high) return rho2 <= s.radius2(p.y);
    return false;
  }

  // The coefficients of a ray that hardly rises have lost what tells its roots from each other.
  bool may_stray() const override { return true; }
  bool strays(const Ray& ray) const override {
    constexpr double kLevel = 0.01;
    const Vec3 d = has_matrix() ? matrix().inverse_direction(ray.direction) : ray.direction;
    return d.y * d.y < kLevel * kLevel * dot(d, d);
  }

  Vec3 geometric_normal(const Hit& hit) const {
    if (hit.part == kBase) return world_normal({0, -1, 0});
    if (hit.part == kCap) return world_normal({0, 1, 0});
    const Vec3 p = local(hit.point);
    const Vec3 n(p.x, -0.5 * segments_[static_cast<std::size_t>(hit.part)].slope(p.y), p.z);
    return n == Vec3(0) ? Vec3(1, 0, 0) : world_normal(n);
  }

  Vec2 uv(const Hit& hit) const override {
    const Vec3 p = local(hit.point);
    const double u = turn_fraction(p.x, p.z), rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (hit.part == kBase) return {u, rho / std::sqrt(base_.radius2) - 1};
    if (hit.part == kCap) return {u, 2 - rho / std::sqrt(cap_.radius2)};
    const Segment& s = segments_[static_cast<std::size_t>(hit.part)];
    return {u, (hit.part + (p.y - s.low) / (s.high - s.low)) / static_cast<double>(segments_.size())};
  }

 private:
  template <class Sink>
  static void add(const Ray& ray, double depth, std::int32_t part, Sink& sink) {
    if (depth > kNearest && depth < kFarthest)
      sink.add(
          depth, [&] { return ray.at(depth); }, part);
  }
  // The hits of the segments that the ray comes to as far as `to`.
  template <class Sink>
  void search(const Ray& ray, const LocalRay& l, Sink& sink, double to) const {
    const Vec3 &p = l.origin, &d = l.direction;
    const double r = d.x * d.x + d.z * d.z, m = d.x * p.x + d.z * p.z, c = p.x * p.x + p.z * p.z;
    double near = kStart, far = std::min(kFarthest, to) * l.scale;  // within the largest radius
    if (r > 1e-20) {
      const double discriminant = m * m - r * (c - outer2_);
      if (!(discriminant >= 0)) return;
      const double root = std::sqrt(discriminant);
      near = std::max(near, (-m - root) / r), far = std::min(far, (-m + root) / r);
    } else if (!(c <= outer2_)) {
      return;
    }
    for (const Segment& s : segments_) {
      if (!enters(s, p.y, d.y, near, far, r, m, c)) continue;
      double roots[3];
      const int n = hits_of(s, p, d, roots);
      // Where a root lies along the ray does not matter, false ones are seen.
      for (int k = 0; k < n; ++k)
        if (const double y = p.y + roots[k] * d.y; y >= s.low && y <= s.high)
          add(ray, roots[k] / l.scale, static_cast<std::int32_t>(&s - segments_.data()), sink);
    }
  }

  struct End {
    double y = 0, radius2 = 0;
  };

  // Whether the interval near .. far of a ray, whose squared distance from the axis is (r t + 2 m) t + c, comes through
  // the annulus of a segment. What leaves it before kStart is not in it (spec 03 4.16): that close to it false roots of
  // nearly level rays would be seen.
  bool enters(const Segment& s, double py, double dy, double near, double far, double r, double m, double c) const {
    if (dy == 0) {
      if (py < s.low || py > s.high) return false;
    } else {
      double from = (s.low - py) / dy, to = (s.high - py) / dy;
      if (from > to) std::swap(from, to);
      near = std::max(near, from), far = std::min(far, to);
    }
    if (!(near <= far)) return false;
    const auto rho2 = [&](double t) { return (r * t + 2 * m) * t + c; };
    const double middle = r > 0 ? std::clamp(-m / r, near, far) : near;
    return rho2(middle) <= (middle == kStart ? s.most2 : s.most2 + slack_) &&
           std::max(rho2(near), rho2(far)) >= s.least2;
  }

  // Where the ray p + t d meets the surface of the segment's cubic at any height.
  int hits_of(const Segment& s, const Vec3& p, const Vec3& d, double* roots) const {
    const double cubic[4] = {s.a * d.y * d.y * d.y, d.y * d.y * (3 * s.a * p.y + s.b) - (d.x * d.x + d.z * d.z),
                             d.y * (p.y * (3 * s.a * p.y + 2 * s.b) + s.c) - 2 * (p.x * d.x + p.z * d.z),
                             p.y * (p.y * (s.a * p.y + s.b) + s.c) + s.d - p.x * p.x - p.z * p.z};
    return solve_polynomial(3, cubic, roots, sturm_);
  }

  template <class Report>
  void each_end(const LocalRay& l, Report&& report) const {
    const Vec3 &p = l.origin, &d = l.direction;
    if (!(std::fabs(d.y) > kEpsilon)) return;
    const auto disc = [&](const End& end, std::int32_t part) {
      const double t = (end.y - p.y) / d.y, x = p.x + t * d.x, z = p.z + t * d.z;
      if (x * x + z * z <= end.radius2) report(t, part);
    };
    if (has_base_) disc(base_, kBase);
    if (has_cap_) disc(cap_, kCap);
  }

  std::vector<Segment> segments_;
  double outer2_ = 0, slack_ = 0;  // slack: for rounding, of squared radii
  End base_, cap_;
  bool has_base_ = false, has_cap_ = false, sturm_;
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
