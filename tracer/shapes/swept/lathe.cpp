// lathe (spec 03 4.15): a profile (radius X(w), height Y(w)) turned about the y axis.
//
// With r = dx^2 + dz^2, m = dx px + dz pz, c = px^2 + pz^2 a ray meets a segment where r (Y - py)^2 + 2 dy m (Y - py) +
// dy^2 (c - X^2) = 0. Coefficients, roots and depths have all of POV-Ray's bits (spec 08 F), and its artefacts at
// nearly level rays.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/first_hit.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/scratch.h"
#include "tracer/shapes/swept/lathe_packet.h"
#include "tracer/shapes/swept/plane_curve.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7;
constexpr double kSteep = 0.01;  // |dy|; what is more level knows its roots less well
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
      : SearchPrimitive(description, {lathe_box(lathe)}), sturm_(description.sturm), range_(lathe) {
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
    if (keeps_first_hit(sink))
      add_first_hit(*this, guards(), sink, [&](auto& hit, double from, double to) { search(ray, hit, from, to); });
    else
      search(ray, sink, sink.lower(), sink.upper());
  }

  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    if (!(t_min > kFirstHit)) return search_packet(rays, t_min, t_max, hit_of, any);
    Hit first[RayPacket::kCount];
    unsigned found = search_packet(
        rays, kFirstHit, t_max, [&](int k) -> Hit& { return first[k]; }, false);
    each_lane(found, [&](int k) {
      if (first[k].t >= t_min) {
        hit_of(k) = first[k];
        return;
      }
      NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
      search(rays.at(k), sink, kFirstHit, first[k].t);
      if (!sink.found()) found &= ~(1u << k);
    });
    return found;
  }

  // The order in which hits are found is not POV-Ray's.
  void turn_hits() override {}

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    if (p.y < range_.y_low || p.y > range_.y_high) return false;
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (rho < range_.r_low || rho > range_.r_high) return false;
    int count = 0;
    for (const Segment& s : segments_) {
      // By rounding a height beside the end of a segment may be taken for it, and be found in both that meet there.
      if (p.y < s.y_low - slack() || p.y > s.y_high + slack()) continue;
      count += s.curve.count_beyond(height, p.y, rho, sturm_);
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
  // Where lane `lane` of a packet may meet a segment.
  struct Candidate {
    int lane;
    double t;
    std::size_t segment;
    friend bool operator<(const Candidate& a, const Candidate& b) {
      return a.lane != b.lane ? a.lane < b.lane : a.t < b.t;
    }
  };
  // Relative to the depth: how far quick roots may lie beside those of POV-Ray.
  static constexpr double kDoubt = 1e-5;

  struct Solver;

  // The hits of segments that the ray comes to between two distances.
  template <class Sink>
  void search(const Ray& ray, Sink& sink, double from, double to) const {
    const Solver solver(unit_local(ray), sturm_);
    const std::optional<LathePassage> passage = this->passage(solver, from, to);
    if (!passage) return;
    for (std::size_t block = 0; block < blocks_.size(); ++block)
      for (unsigned met = lathe_kernels().along(blocks_[block], *passage); met != 0; met &= met - 1) {
        const std::size_t i = 8 * block + static_cast<std::size_t>(std::countr_zero(met));
        if (i >= segments_.size()) break;  // of numbers that are none
        solver.segment(segments_[i].curve, [&](double w, double t) { add(ray, t, i, w, sink); });
      }
  }

  template <class HitOf>
  unsigned search_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.active;
    if (admitted == 0) return 0;
    LathePacket packet;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, packet.rays);
    const unsigned met = lathe_kernels().begin(outer2(), admitted, packet);
    std::optional<Solver> solvers[RayPacket::kCount];
    std::optional<NearestHit> sinks[RayPacket::kCount];
    std::optional<LathePassage> passages[RayPacket::kCount];
    unsigned found = 0, open = 0;
    each_lane(met, [&](int k) {
      solvers[k].emplace(unit_local(rays.at(k)), sturm_);
      sinks[k].emplace(*this, guards(), t_min, t_max[k], hit_of(k), any);
      passages[k] = passage(*solvers[k], t_min, t_max[k]);
      open |= passages[k] ? 1u << k : 0;
    });
    const auto solve = [&](int k, std::size_t i) {
      solvers[k]->segment(segments_[i].curve, [&](double w, double t) { add(rays.at(k), t, i, w, *sinks[k]); });
    };
    Scratch<Candidate> candidates;
    unsigned along[RayPacket::kCount];
    for (std::size_t i = 0; i < segments_.size() && open != 0; ++i) {
      const Segment& s = segments_[i];
      if (i % 8 == 0) each_lane(open, [&](int k) { along[k] = lathe_kernels().along(blocks_[i / 8], *passages[k]); });
      unsigned beside = 0;
      each_lane(open, [&](int k) { beside |= (along[k] >> i % 8 & 1) << k; });
      const unsigned surveyed = s.curve.degree > 1 ? beside & steep(packet) : 0;
      RootPacket roots;
      unsigned near = 0;
      if (surveyed != 0) {
        lathe_kernels().follow(s.curve, packet, roots);
        near = bernstein_kernels().begin(2 * s.curve.degree, surveyed, roots);
      }
      if (s.curve.degree < 3) {  // closed forms
        each_lane((beside & ~surveyed) | near, [&](int k) { solve(k, i); });
      } else {
        each_lane(beside & ~surveyed, [&](int k) { solve(k, i); });
        while ((near = bernstein_kernels().next(2 * s.curve.degree, near, roots)) != 0)
          each_lane(near, [&](int k) {
            const double w = roots.root[k], t = solvers[k]->depth(s.curve, w), doubt = kDoubt * (1 + t);
            if (any && !guards() && t > std::max(t_min, kNearest) + doubt && t < t_max[k] - doubt)
              add(rays.at(k), t, i, w, *sinks[k]);
            else if (t > t_min - doubt && t < t_max[k] + doubt)
              candidates.add({k, t, i});
          });
      }
      if (any) each_lane(open, [&](int k) { open &= ~(sinks[k]->found() ? 1u << k : 0); });
    }
    // The nearest one that has POV-Ray's bits, too.
    candidates.sort();
    for (std::size_t n = 0; n < candidates.size(); ++n) {
      const auto& [k, t, i] = candidates[n];
      if (sinks[k]->found() && (any || t > hit_of(k).t + kDoubt * (1 + t))) continue;
      if (n == 0 || candidates[n - 1].lane != k || candidates[n - 1].segment != i) solve(k, i);
    }
    each_lane(met, [&](int k) { found |= sinks[k]->found() ? 1u << k : 0; });
    return found;
  }

  // Where a ray is within the outermost cylinder, between two world distances; nothing: nowhere.
  std::optional<LathePassage> passage(const Solver& solver, double lower, double upper) const {
    const auto& [l, r, m, c, sturm] = solver;
    double near = -HUGE_VAL, far = HUGE_VAL;
    const double outer2 = this->outer2();
    if (r > 1e-20) {
      const double discriminant = m * m - r * (c - outer2);
      if (!(discriminant >= 0)) return {};
      const double root = std::sqrt(discriminant);
      near = (-m - root) / r, far = (-m + root) / r;
      if (far < 0) return {};
    } else if (!(c <= outer2)) {
      return {};
    }
    const double doubt = 1e-7 * (range_.r_high + std::sqrt(c));
    near = std::max({near, 0.0, lower * l.scale - doubt}), far = std::min(far, upper * l.scale + doubt);
    if (near > far) return {};
    double y0 = l.origin.y + l.direction.y * near, y1 = l.origin.y + l.direction.y * far;
    if (!(std::fabs(l.direction.y) > 0)) y0 = y1 = l.origin.y;
    if (y0 > y1) std::swap(y0, y1);
    LathePassage p{y0, y1, slack(), r, m, c, l.origin.y, near, far};
    if (std::fabs(l.direction.y) > kSteep)
      p.inverse = 1 / l.direction.y, p.turn = r > 1e-20 ? -m / r : 0, p.doubt = 1e-5 * outer2 + 1e-9 * (c + m * m);
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

  static unsigned steep(const LathePacket& packet) {
    unsigned steep = 0;
    for (int k = 0; k < RayPacket::kCount; ++k) steep |= std::fabs(packet.rays.dy[k]) > kSteep ? 1u << k : 0;
    return steep;
  }

  // One ray and the depths at which it meets a segment, at w of its curve.
  struct Solver {
    const LocalRay l;
    const double r, m, c;
    const bool sturm;
    Solver(const LocalRay& ray, bool by_sturm)
        : l(ray),
          r(l.direction.x * l.direction.x + l.direction.z * l.direction.z),
          m(l.origin.x * l.direction.x + l.origin.z * l.direction.z),
          c(l.origin.x * l.origin.x + l.origin.z * l.origin.z),
          sturm(by_sturm) {}

    template <class Report>
    void segment(const CurveSegment& s, Report&& report) const {
      const double py = l.origin.y, dy = l.direction.y;
      double coefficients[7], roots[6];
      const auto& [c0, c1, c2, c3] = s.c;
      const double z = c0.y - py, dym = dy * m, dy2 = dy * dy;
      coefficients[0] = r * (c3.y * c3.y) - dy2 * (c3.x * c3.x);
      coefficients[1] = 2 * (r * (c2.y * c3.y) - dy2 * (c2.x * c3.x));
      coefficients[2] = r * (2 * c1.y * c3.y + c2.y * c2.y) - dy2 * (2 * c1.x * c3.x + c2.x * c2.x);
      coefficients[3] =
          2 * (r * (c0.y * c3.y + c1.y * c2.y - py * c3.y) + c3.y * dy * m - dy2 * (c0.x * c3.x + c1.x * c2.x));
      coefficients[4] = r * (2 * c2.y * z + c1.y * c1.y) + 2 * c2.y * dy * m - dy2 * (2 * c2.x * c0.x + c1.x * c1.x);
      coefficients[5] = 2 * (c1.y * (r * z + dym) - dy2 * (c1.x * c0.x));
      coefficients[6] = z * (r * z + 2 * dym) + dy2 * (c - c0.x * c0.x);
      const int n = solve_polynomial(2 * s.degree, coefficients + 6 - 2 * s.degree, roots, sturm, 0, 0, 1);
      for (int i = 0; i < n; ++i) {
        const double w = roots[i];
        if (!(w >= 0 && w <= 1)) continue;
        if (std::fabs(dy) > kEpsilon)
          report(w, depth(s, w));
        else
          level(s.value(radius, w), [&](double t) { report(w, t); });
      }
    }

    double depth(const CurveSegment& s, double w) const {
      return (s.value(height, w) - l.origin.y) / (l.direction.y * l.scale);
    }
    // A level ray, where the profile has this radius.
    template <class Report>
    void level(double x, Report&& report) const {
      const double chord[3] = {r, 2 * m, c - x * x};
      double depths[2];
      const int n = solve_polynomial(2, chord, depths);
      for (int i = 0; i < n; ++i) report(depths[i] / l.scale);
    }
  };

  const bool sturm_;
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
