// prism (spec 03 4.17): an outline (x, z) swept along y, straight or towards the origin.
#include <algorithm>
#include <cmath>

#include "tracer/bvh/bvh.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/intersections.h"
#include "tracer/shapes/swept/outline_index.h"
#include "tracer/shapes/swept/plane_curve.h"
#include "tracer/shapes/swept/straight_prism.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

namespace wall {
using namespace one_ray;
#include "tracer/shapes/swept/prism_wall.inc"
}  // namespace wall
using wall::within_reach;

constexpr std::int32_t kCap = -1;
enum Axis { along_x, along_z };

bool same(const Vec2& a, const Vec2& b) { return std::fabs(a.x - b.x) < kEpsilon && std::fabs(a.y - b.y) < kEpsilon; }

// The closed outlines; empty if one of them is not closed (a linear one is closed instead).
std::vector<CurveSegment> segments_of(const scene::Prism& prism) {
  std::vector<CurveSegment> segments;
  const std::vector<Vec2>& p = prism.points;
  const std::size_t n = p.size();
  std::size_t i = 0;
  switch (prism.spline) {
    case scene::SplineKind::linear:
      while (i + 1 < n) {
        const std::size_t first = i;
        bool closed = false;
        for (; i + 1 < n && !closed; ++i) {
          closed = same(p[i + 1], p[first]);
          segments.push_back(CurveSegment::linear(p[i], closed ? p[first] : p[i + 1]));
        }
        if (!closed) segments.push_back(CurveSegment::linear(p[i], p[first]));
        ++i;
      }
      return segments;
    case scene::SplineKind::quadratic:
      while (i + 2 < n) {
        const Vec2 first = p[i + 1];
        bool closed = false;
        for (; i + 2 < n && !closed; ++i) {
          segments.push_back(CurveSegment::quadratic(p[i], p[i + 1], p[i + 2]));
          closed = same(p[i + 2], first);
        }
        if (!closed) return {};
        i += 2;
      }
      return segments;
    case scene::SplineKind::bezier: {
      bool open = false;
      Vec2 first(0);
      for (; i + 3 < n; i += 4) {
        if (!open) first = p[i];
        segments.push_back(CurveSegment::bezier(p[i + 3], p[i + 2], p[i + 1], p[i]));
        open = !same(p[i + 3], first);
      }
      if (open) return {};
      return segments;
    }
    default:
      while (i + 3 < n) {
        const Vec2 first = p[i + 1];
        bool closed = false;
        for (; i + 3 < n && !closed; ++i) {
          segments.push_back(CurveSegment::cubic(p[i], p[i + 1], p[i + 2], p[i + 3]));
          closed = same(p[i + 2], first);
        }
        if (!closed) return {};
        i += 3;
      }
      return segments;
  }
}

// What POV-Ray takes a segment's extent for: of a Bezier segment, its control points'.
std::vector<Rectangle> ranges_of(const scene::Prism& prism, const std::vector<CurveSegment>& segments) {
  std::vector<Rectangle> ranges;
  for (const CurveSegment& s : segments) {
    Rectangle range;
    if (prism.spline == scene::SplineKind::bezier) {
      for (std::size_t k = 4 * ranges.size(), end = k + 4; k < end; ++k) range.extendBy(prism.points[k]);
    } else {
      s.extremes(along_x, range.min.x, range.max.x);
      s.extremes(along_z, range.min.y, range.max.y);
    }
    ranges.push_back(range);
  }
  return ranges;
}

class Prism final : public Primitive<Prism>, public StraightPrism {
 public:
  Prism(const scene::Object& description, const scene::Prism& prism)
      : Primitive(description, {prism_box(prism)}),
        conic_(prism.conic),
        open_(prism.open),
        sturm_(description.sturm),
        low_(std::min(prism.low, prism.high)),
        high_(std::max(prism.low, prism.high)),
        box_(prism_box(prism)) {
    const Vec3 pad = 1e-9 * (box_.max - box_.min) + Vec3(1e-12);
    box_.min -= pad, box_.max += pad;
    const std::vector<CurveSegment> curves = segments_of(prism);
    const std::size_t parts = std::clamp<std::size_t>(curves.empty() ? 1 : kPieces / curves.size(), 1, kMaxParts);
    std::vector<Rectangle> bounds;
    const std::vector<Rectangle> ranges = ranges_of(prism, curves);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const CurveSegment& s = curves[i];
      const Rectangle& range = ranges[i];
      Segment segment{s, range.min.x, range.max.x, range.min.y, range.max.y, pieces_.size(), 0};
      outline_.extendBy(range);
      const std::size_t count = s.degree == 1 ? 1 : parts;
      for (std::size_t k = 0; k < count; ++k) {
        const auto w = [&](std::size_t at) { return static_cast<double>(at) / static_cast<double>(count); };
        bounds.push_back(s.bounds(w(k), w(k + 1)));
        pieces_.push_back({segments_.size(), bounds.back(), s.value(along_z, w(k)), s.value(along_z, w(k + 1))});
        middles_.emplace_back(bounds.back());
      }
      segment.end_piece = pieces_.size();
      segments_.push_back(segment);
    }
    index_ = OutlineIndex(bounds);
    add_straight();
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = unit_local(ray);
    const Vec3 &o = l.origin, &d = l.direction;
    const auto report = [&](double t, std::int32_t part, double w) {
      const double depth = t / l.scale;
      if (within_reach(depth))
        sink.add(
            depth, [&] { return ray.origin + depth * ray.direction; }, part, w);
    };
    double enter = 0, leave = HUGE_VAL;
    if (!accel::clip_to_box({o, d}, box_, enter, leave)) return;
    if (std::fabs(d.y) > kEpsilon) {
      if (!open_) {
        // Where only the nearest hit is wanted, the nearer cap may spare the other one.
        const bool downwards = Sink::kNearest && d.y < 0 && low_ < high_;
        for (const double h : {downwards ? high_ : low_, downwards ? low_ : high_}) {
          if (conic_ && std::fabs(h) <= kEpsilon) continue;
          const double t = (h - o.y) / d.y, size = conic_ ? h : 1;
          if (!(t >= sink.lower() * l.scale * (1 - 1e-9) && t <= sink.upper() * l.scale * (1 + 1e-9))) continue;
          if (!within_reach(t)) continue;  // of caps, not of walls
          if (covers((o.x + t * d.x) / size, (o.z + t * d.z) / size)) report(t, kCap, 0);
        }
      }
    } else if (o.y < low_ || o.y > high_) {
      return;
    }
    if (sink.upper() < sink.lower()) return;
    // Along the axis POV-Ray asks no walls, though those of a conic sweep slope.
    if (std::fabs(d.x) <= kEpsilon && std::fabs(d.z) <= kEpsilon) return;
    // The outline's point lies on the ray's line when nx X + nz Z + n0 = 0.
    const double nx = conic_ ? o.z * d.y - o.y * d.z : d.z, nz = conic_ ? o.y * d.x - o.x * d.y : -d.x;
    const double n0 = conic_ ? o.x * d.z - o.z * d.x : o.z * d.x - o.x * d.z;
    // What rounding may add to it.
    const double doubt =
        1e-12 * (std::fabs(nx) * farthest(along_x) + std::fabs(nz) * farthest(along_z) + std::fabs(n0));
    std::size_t i = segments_.size();  // the segment met last; pieces come in its order
    index_.overlapping(seen_from_above(o, d, enter, std::min(leave, sink.upper() * l.scale)), [&](std::size_t piece) {
      if (!middles_[piece].straddles(nx, nz, n0, doubt) || pieces_[piece].segment == i) return;
      i = pieces_[piece].segment;
      const CurveSegment& s = segments_[i].curve;
      const auto part = static_cast<std::int32_t>(i);
      if (s.degree == 1 && !conic_) {
        const auto add = [&](double t, std::int32_t) { return report(t, part, 0), false; };
        return wall::wall_intersection(o, d, straight(s), low_, high_, true, part, one_ray::Report{add});
      }
      double falling[4], roots[3];
      for (int k = 0; k <= s.degree; ++k) {
        const Vec2& c = s.c[static_cast<std::size_t>(k)];
        falling[s.degree - k] = nx * c.x + nz * c.y;
      }
      // In POV-Ray's order: what lies in a wall is decided by last digits.
      double& constant = falling[s.degree];
      constant = conic_ ? constant + n0 : nx * (s.c[0].x - o.x) + nz * (s.c[0].y - o.z);
      int n = 0;
      if (s.degree == 1) {
        roots[0] = -constant / falling[0];
        n = wall::is_on_segment(falling[0], roots[0]) ? 1 : 0;
      } else {
        n = solve_polynomial(s.degree, falling, roots, sturm_);
      }
      for (int k = 0; k < n; ++k) {
        if (!(roots[k] >= 0 && roots[k] <= 1)) continue;
        const double x = s.value(along_x, roots[k]), z = s.value(along_z, roots[k]);
        double t;  // by x wherever it changes at all, as in POV-Ray
        if (conic_) {
          const double by_x = d.x - x * d.y, by_z = d.z - z * d.y;
          t = std::fabs(by_x) > kEpsilon ? (x * o.y - o.x) / by_x : (z * o.y - o.z) / by_z;
        } else {
          t = wall::distance_to_wall(o, d, x, z);
        }
        const double y = o.y + t * d.y;
        if (y >= low_ && y <= high_) report(t, part, roots[k]);
      }
    });
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    if (!(p.y >= low_ && p.y < high_)) return false;
    if (!conic_) return covers(p.x, p.z);
    return std::fabs(p.y) > kEpsilon && covers(p.x / p.y, p.z / p.y);
  }

  Vec3 geometric_normal(const Hit& hit) const {
    if (hit.part == kCap) return world_normal({0, 1, 0});
    const CurveSegment& s = segments_[static_cast<std::size_t>(hit.part)].curve;
    Vec3 n(s.slope(along_z, hit.u), 0, -s.slope(along_x, hit.u));
    if (conic_) {
      const Vec3 p = local(hit.point);
      if (std::fabs(p.y) > kEpsilon) n.y = -(p.x * n.x + p.z * n.z) / p.y;
    }
    return n == Vec3(0) ? Vec3(1, 0, 0) : world_normal(n);
  }

  const Walls* straight_walls() const override { return straight_.get(); }
  // Even-odd count along +x. As in POV-Ray every segment owns both its ends, so a line exactly through a vertex counts
  // it twice (spec 03 section 8).
  bool covers(double x, double z) const {
    if (x > outline_.max.x || x < outline_.min.x || z < outline_.min.y || z > outline_.max.y) return false;
    int count = 0;
    std::size_t last = segments_.size();
    index_.overlapping(Rectangle(Vec2(x, z), Vec2(HUGE_VAL, z)), [&](std::size_t piece) {
      if (pieces_[piece].segment == last) return;
      last = pieces_[piece].segment;
      const Segment& s = segments_[last];
      if (!(z < s.z_low || z > s.z_high || x > s.x_high)) count += times_met(s, x, z);
    });
    return count & 1;
  }

 private:
  struct Segment {
    CurveSegment curve;
    double x_low, x_high, z_low, z_high;
    std::size_t first_piece, end_piece;
  };
  // A part of a segment with narrow bounds.
  struct Piece {
    std::size_t segment;
    Rectangle bounds;
    double z_begin, z_end;
  };
  // The rectangle of a piece, as rays ask for it.
  struct Middle {
    double x, z, width, depth;  // half of both

    explicit Middle(const Rectangle& r)
        : x(0.5 * (r.min.x + r.max.x)),
          z(0.5 * (r.min.y + r.max.y)),
          width(0.5 * (r.max.x - r.min.x) * (1 + 1e-9)),
          depth(0.5 * (r.max.y - r.min.y) * (1 + 1e-9)) {}
    // Whether the line nx x + nz z + n0 = 0 may pass through it.
    bool straddles(double nx, double nz, double n0, double doubt) const {
      return std::fabs(nx * x + nz * z + n0) <= std::fabs(nx) * width + std::fabs(nz) * depth + doubt;
    }
  };
  static constexpr std::size_t kPieces = 64,
                               kMaxParts = 16;  // of all curved segments together, if they are few; of one

  static StraightSegment straight(const CurveSegment& s) { return {s.c[0].x, s.c[0].y, s.c[1].x, s.c[1].y}; }
  void add_straight() {
    const auto curved = [](const Segment& s) { return s.curve.degree != 1; };
    if (conic_ || guards() || segments_.size() > kMaxSegments || std::ranges::any_of(segments_, curved)) return;
    const double size = std::max({farthest(along_x), farthest(along_z), std::fabs(low_), std::fabs(high_)});
    straight_ = std::make_unique<Walls>(
        Walls{has_matrix() ? &matrix() : nullptr, inverted(), open_, low_, high_, outline_, size, {}});
    for (const Segment& s : segments_)
      straight_->segments.push_back({straight(s.curve), s.x_low, s.x_high, s.z_low, s.z_high});
  }

  // The largest coordinate of the outline.
  double farthest(Axis axis) const {
    const int k = axis == along_x ? 0 : 1;
    return std::max(std::fabs(outline_.min[k]), std::fabs(outline_.max[k]));
  }

  // What the interval of a ray that matters covers of the outline's plane; of a conic sweep, everything.
  Rectangle seen_from_above(const Vec3& o, const Vec3& d, double enter, double end) const {
    if (conic_) return Rectangle(Vec2(-HUGE_VAL), Vec2(HUGE_VAL));
    const double slack = 1e-9 * (std::fabs(o.x) + std::fabs(o.z) + end) + 1e-12;
    Rectangle r(Vec2(o.x + enter * d.x, o.z + enter * d.z));
    r.extendBy(Vec2(o.x + end * d.x, o.z + end * d.z));
    return Rectangle(r.min - Vec2(slack), r.max + Vec2(slack));
  }

  // How often a segment with z in its range is met by the line from a point along +x, up to even numbers. Only a piece
  // whose bounds hold the point asks for roots: one to the right is met if its ends lie on different sides.
  int times_met(const Segment& s, double x, double z) const {
    if (s.curve.degree == 1) {
      const Piece& p = pieces_[s.first_piece];
      return x < s.x_low && p.z_begin != p.z_end ? 1 : s.curve.count_beyond(along_z, z, x, sturm_);
    }
    if (level_with_end(s, z)) return s.curve.count_beyond(along_z, z, x, sturm_);
    int count = 0;
    for (std::size_t i = s.first_piece; i < s.end_piece; ++i) {
      const Piece& p = pieces_[i];
      if (z < p.bounds.min.y || z > p.bounds.max.y || x > p.bounds.max.x) continue;
      if (x >= p.bounds.min.x || z == p.z_begin || z == p.z_end) return s.curve.count_beyond(along_z, z, x, sturm_);
      count += (p.z_begin < z) != (p.z_end < z);
    }
    return count;
  }
  // Whether z lies so near to an end of a segment that the rounding of the closed forms decides which segment owns it.
  bool level_with_end(const Segment& s, double z) const {
    const double slack = 1e-7 * (s.z_high - s.z_low);
    return std::fabs(z - pieces_[s.first_piece].z_begin) < slack ||
           std::fabs(z - pieces_[s.end_piece - 1].z_end) < slack;
  }
  bool conic_, open_, sturm_;
  double low_, high_;
  Box3 box_;
  Rectangle outline_;
  std::vector<Segment> segments_;
  std::vector<Piece> pieces_;  // by segments
  std::vector<Middle> middles_;
  OutlineIndex index_;  // of the pieces
  std::unique_ptr<Walls> straight_;
};

}  // namespace

Box3 prism_box(const scene::Prism& prism) {
  const double low = std::min(prism.low, prism.high), high = std::max(prism.low, prism.high);
  Box3 box;
  for (const Rectangle& range : ranges_of(prism, segments_of(prism))) {
    for (const double h : {low, high}) {
      const double size = prism.conic ? h : 1;
      box.extendBy({size * range.min.x, h, size * range.min.y});
      box.extendBy({size * range.max.x, h, size * range.max.y});
    }
  }
  return box;
}

std::unique_ptr<Shape> compile_prism(const scene::Object& object) {
  return std::make_unique<Prism>(object, **object.as<std::shared_ptr<const scene::Prism>>());
}

}  // namespace verisim::shapes
