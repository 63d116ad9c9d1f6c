// blob (spec 03 4.13): the surface where the fields of spheres and capsules, strength (1 - d^2 / r^2)^2 each, add up to the threshold.
//
// A capsule is three parts: a cylinder and two half spheres. Along a ray every part has an interval and a quartic; between the ends of intervals the
// sum is one quartic, whose roots are isolated by its Bernstein coefficients.
#include <algorithm>
#include <cmath>

#include "tracer/accel/box_tree.h"
#include "tracer/math/bernstein.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/scratch.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-2, kFarthest = 1e7, kShortest = 1e-10, kInsideMargin = 1e-6;
constexpr std::size_t kFewParts = 2, kFewPieces = 24;
constexpr std::size_t kMaxTextures = 512;

enum class PartKind : unsigned char { sphere, cylinder, base, apex };

struct Part {
  PartKind kind;
  bool moved = false;       // `inverse` counts
  std::int32_t component = 0;
  Vec3 center;              // of a sphere or half sphere; the base of a cylinder
  Vec3 axis;                // unit; of all but spheres
  double length = 0;        // of a cylinder
  double radius2 = 0, k0 = 0, k1 = 0, k2 = 0;  // field = k0 D^2 + k1 D + k2 of the squared distance D
  Transform transform;
  Box3 box, pov_box;        // in the blob's space: of its reach, and as POV-Ray has it
};

// D = a t^2 + 2 b t + c along a ray, valid for t0 < t < t1.
struct Piece {
  double t0, t1, a, b, c;
  const Part* part;
  double peak = 0;  // no more than this does it add to the field, but for rounding
  bool expanded = false;
  double power[5] = {};  // what it adds to the field, in powers of the parameter that all pieces of a ray share; if expanded
};

struct Event {
  double t;
  std::int32_t piece;
  bool enters;
  bool operator<(const Event& other) const { return t < other.t; }
};

// A sphere that POV-Ray draws around a part, as a cube; generous for transformed ones.
Box3 cube_around(const Vec3& center, double radius, const Transform& t) {
  Box3 box;
  for (int corner = 0; corner < 8; ++corner)
    box.extendBy(t.point(center + radius * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  const Vec3 size = box.max - box.min;
  const Vec3 half(0.5 * std::max({size.x, size.y, size.z}));
  const Vec3 moved = t.point(center);
  return {moved - half, moved + half};
}

// The box of a moved sphere.
Box3 box_of_sphere(const Vec3& center, double radius, const Transform& t) {
  const Vec3 moved = t.point(center);
  Vec3 half;
  for (int i = 0; i < 3; ++i) half[i] = radius * (1 + 1e-9) * std::sqrt(t.m[0][i] * t.m[0][i] + t.m[1][i] * t.m[1][i] + t.m[2][i] * t.m[2][i]);
  return {moved - half, moved + half};
}

std::vector<Part> parts_of(const scene::Blob& blob) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    const scene::BlobComponent& c = blob.components[i];
    Part part;
    part.component = static_cast<std::int32_t>(i);
    part.radius2 = c.radius * c.radius;
    part.k0 = c.strength / (part.radius2 * part.radius2);
    part.k1 = -2 * c.strength / part.radius2;
    part.k2 = c.strength;
    part.moved = c.transform.has_value();
    part.transform = c.transform.value_or(Transform{});
    part.center = c.a;
    const double radius = std::fabs(c.radius);
    if (!c.cylinder) {
      part.kind = PartKind::sphere;
      part.pov_box = cube_around(c.a, radius, part.transform);
      part.box = box_of_sphere(c.a, radius, part.transform);
      parts.push_back(part);
      continue;
    }
    const double len = length(c.b - c.a);
    part.axis = (c.b - c.a) / len;
    part.length = len;
    const Transform frame = frame_along(c.a, part.axis, 1, 1).then(part.transform);
    part.kind = PartKind::cylinder;
    const Box3 base = box_of_sphere(c.a, radius, part.transform), apex = box_of_sphere(c.b, radius, part.transform);
    part.pov_box = cube_around({0, 0, 0.5 * len}, std::sqrt(part.radius2 + 0.25 * len * len), frame);
    part.box = base;
    part.box.extendBy(apex);
    parts.push_back(part);
    part.kind = PartKind::base;
    part.pov_box = cube_around(Vec3(0), radius, frame);
    part.box = base;
    parts.push_back(part);
    part.kind = PartKind::apex;
    part.center = c.b;
    part.pov_box = cube_around({0, 0, len}, radius, frame);
    part.box = apex;
    parts.push_back(part);
  }
  return parts;
}

// Where the surface can be: with a positive threshold, within reach of a positive part.
Box3 box_of(const std::vector<Part>& parts, bool all) {
  Box3 box;
  for (const Part& part : parts)
    if (all || part.k2 > 0) box.extendBy(part.box);
  return box;
}

class Blob final : public Primitive<Blob> {
 public:
  Blob(const scene::Object& description, const scene::Blob& blob) : Blob(description, blob, parts_of(blob)) {}

  template <class Sink>
  void crossings(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    Scratch<Piece> pieces;
    if (tree_.empty()) {
      for (const Part& part : parts_) add_piece(part, l, pieces);
    } else {
      tree_.traverse({l.origin, l.direction}, 0, HUGE_VAL, [&](std::uint32_t i, double limit) {
        add_piece(parts_[i], l, pieces);
        return limit;
      });
    }
    if (pieces.size() == 0) return;
    double peak = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) peak += pieces[i].peak;
    if (misses(peak)) return;

    Scratch<Event> events;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      events.insert_sorted({pieces[i].t0, static_cast<std::int32_t>(i), true}, kFewPieces);
      events.insert_sorted({pieces[i].t1, static_cast<std::int32_t>(i), false}, kFewPieces);
    }
    if (events.size() > kFewPieces) events.sort();
    const double start = events[0].t, span = events[events.size() - 1].t - start;
    if (!(span > 0) || !std::isfinite(span)) return;

    Scratch<std::int32_t> active;
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      update(events[i], active);
      const double from = (events[i].t - start) / span;
      double to = (events[i + 1].t - start) / span;
      while (to - from < kShortest && i + 2 < events.size()) {
        update(events[++i], active);
        to = (events[i + 1].t - start) / span;
      }
      if (active.size() == 0) continue;
      if (solve_interval(ray, l, pieces, active, start, span, from, to, sink)) return;
    }
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    double sum = 0;
    at(p, [&](const Part& part, double d2, const Vec3&) { sum += field(part, d2); });
    return sum > threshold_ - kInsideMargin;
  }

  Vec3 raw_normal(const Hit& hit) const {
    const Vec3 p = local(hit.point);
    Vec3 gradient(0);
    at(p, [&](const Part& part, double d2, const Vec3& to_point) {
      const Vec3 g = -2 * (2 * part.k0 * d2 + part.k1) * to_point;
      gradient += part.moved ? part.transform.normal(g) : g;
    });
    if (gradient == Vec3(0)) return {1, 0, 0};
    return world_normal(gradient);
  }

  std::span<const scene::TexturePtr> extra_textures() const override { return textures_; }
  void texture_shares(const Hit& hit, bool, std::vector<TextureShare>& shares) const override {
    double total = 0;
    at(local(hit.point), [&](const Part& part, double d2, const Vec3&) {
      const double weight = std::fabs(field(part, d2));
      if (weight == 0 || shares.size() >= kMaxTextures) return;
      total += weight;
      const auto c = static_cast<std::size_t>(part.component);
      shares.push_back({textures_[c] ? part.component : -1, static_cast<float>(weight)});
    });
    for (TextureShare& share : shares) share.weight = static_cast<float>(share.weight / total);
  }

 private:
  Blob(const scene::Object& description, const scene::Blob& blob, std::vector<Part> parts)
      : Primitive(description, {box_of(parts, blob.threshold <= 0), blob.threshold > kInsideMargin}), threshold_(blob.threshold), parts_(std::move(parts)) {
    const auto textured = [](const scene::BlobComponent& c) { return c.texture != nullptr; };
    if (std::any_of(blob.components.begin(), blob.components.end(), textured))
      for (const scene::BlobComponent& c : blob.components) textures_.push_back(c.texture);
    std::vector<Box3> boxes;
    bool finite = true;
    for (const Part& part : parts_) {
      boxes.push_back(part.box);
      finite = finite && accel::is_finite(part.box) && !accel::is_empty(part.box);
    }
    if (parts_.size() > kFewParts && finite) tree_ = accel::BoxTree(boxes);
  }

  static double field(const Part& part, double d2) { return (part.k0 * d2 + part.k1) * d2 + part.k2; }

  // Squared distance of p from a part's centre or axis; false outside its reach. `to_point` points from there to p, in the component's own space.
  static bool reach(const Part& part, const Vec3& p, double& d2, Vec3& to_point) {
    const Vec3 q = part.moved ? part.transform.inverse_point(p) : p;
    to_point = q - part.center;
    if (part.kind != PartKind::sphere) {
      const double z = dot(to_point, part.axis);
      if (part.kind == PartKind::base && z > 0) return false;
      if (part.kind == PartKind::apex && z < 0) return false;
      if (part.kind == PartKind::cylinder) {
        if (z < 0 || z > part.length) return false;
        to_point -= z * part.axis;
      }
    }
    d2 = dot(to_point, to_point);
    return d2 < part.radius2;
  }

  template <class Visit>
  void at(const Vec3& p, Visit&& visit) const {
    const auto test = [&](const Part& part) {
      double d2;
      Vec3 to_point;
      if (reach(part, p, d2, to_point)) visit(part, d2, to_point);
    };
    if (tree_.empty()) {
      for (const Part& part : parts_) test(part);
      return;
    }
    tree_.any_around(p, [&](std::uint32_t i) {
      test(parts_[i]);
      return false;
    });
  }

  // The stretch of the ray within a part's reach.
  static void add_piece(const Part& part, const LocalRay& l, Scratch<Piece>& pieces) {
    Vec3 o = l.origin, d = l.direction;
    if (part.moved) o = part.transform.inverse_point(o), d = part.transform.inverse_direction(d);
    o -= part.center;
    Piece piece{0, HUGE_VAL, dot(d, d), dot(o, d), dot(o, o), &part};
    if (part.kind != PartKind::sphere) {
      const double z0 = dot(o, part.axis), dz = dot(d, part.axis);
      if (part.kind == PartKind::cylinder) piece.a -= dz * dz, piece.b -= z0 * dz, piece.c -= z0 * z0;
      const double low = part.kind == PartKind::base ? -HUGE_VAL : 0;
      const double high = part.kind == PartKind::base ? 0 : part.kind == PartKind::cylinder ? part.length : HUGE_VAL;
      if (std::fabs(dz) < kEpsilon) {
        if (z0 < low || z0 > high) return;
      } else {
        double enter = (low - z0) / dz, leave = (high - z0) / dz;
        if (enter > leave) std::swap(enter, leave);
        piece.t0 = std::max(piece.t0, enter), piece.t1 = std::min(piece.t1, leave);
      }
    }
    if (piece.a > kEpsilon) {
      const double discriminant = piece.b * piece.b - piece.a * (piece.c - part.radius2);
      if (!(discriminant > 0)) return;
      const double root = std::sqrt(discriminant);
      piece.t0 = std::max(piece.t0, (-piece.b - root) / piece.a);
      piece.t1 = std::min(piece.t1, (-piece.b + root) / piece.a);
    } else if (!(piece.c < part.radius2)) {
      return;
    }
    if (!(piece.t1 > piece.t0 && piece.t1 < HUGE_VAL)) return;
    // The field of a positive part is largest where the ray is closest.
    if (part.k2 > 0) piece.peak = piece.a > kEpsilon ? field(part, std::max(piece.c - piece.b * piece.b / piece.a, 0.0)) : part.k2;
    pieces.add(piece);
  }

  static void update(const Event& event, Scratch<std::int32_t>& active) {
    if (event.enters) {
      active.add(event.piece);
      return;
    }
    std::size_t i = 0;
    while (active[i] != event.piece) ++i;
    active[i] = active[active.size() - 1];
    active.pop();
  }

  // Reports the hits between `from` and `to` of the rescaled parameter; true if the search may stop.
  template <class Sink>
  bool solve_interval(const Ray& ray, const LocalRay& l, Scratch<Piece>& pieces, const Scratch<std::int32_t>& active, double start, double span,
                      double from, double to, Sink& sink) const {
    double peak = 0;
    for (std::size_t k = 0; k < active.size(); ++k) peak += pieces[static_cast<std::size_t>(active[k])].peak;
    if (misses(peak)) return false;
    double power[5] = {-threshold_, 0, 0, 0, 0};
    for (std::size_t k = 0; k < active.size(); ++k) {
      Piece& piece = pieces[static_cast<std::size_t>(active[k])];
      if (!piece.expanded) expand(piece, start, span);
      for (int i = 0; i < 5; ++i) power[i] += piece.power[i];
    }
    double roots[4];
    const int n = bernstein_roots<4>(power, from, to, roots);
    bool stop = false;
    for (int i = 0; i < n; ++i) {
      const double depth = (start + span * roots[i]) / l.scale;
      // Searches from within (subsurface scattering) ask for everything in front, and POV-Ray's own leave nothing out there.
      const double nearest = Sink::kNearest && sink.lower() == std::numeric_limits<double>::min() ? 1e-7 : kNearest;
      if (!(depth > nearest && depth < kFarthest)) continue;
      const bool accepted = sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
      if (Sink::kNearest && accepted) {
        stop = true;
        break;
      }
    }
    return stop;
  }

  // Fields that add up to no more than `peak` do not reach the threshold, whatever the rounding.
  bool misses(double peak) const { return peak < threshold_ - 1e-6 * (1 + std::fabs(threshold_)); }

  static void expand(Piece& piece, double start, double span) {
    const Part& part = *piece.part;
    const double a = piece.a * span * span, b = 2 * (piece.b + piece.a * start) * span, c = piece.c + start * (2 * piece.b + start * piece.a);
    piece.power[4] = part.k0 * a * a;
    piece.power[3] = part.k0 * 2 * a * b;
    piece.power[2] = part.k0 * (b * b + 2 * a * c) + part.k1 * a;
    piece.power[1] = part.k0 * 2 * b * c + part.k1 * b;
    piece.power[0] = field(part, c);
    piece.expanded = true;
  }

  double threshold_;
  std::vector<Part> parts_;
  accel::BoxTree tree_;
  std::vector<scene::TexturePtr> textures_;
};

}  // namespace

Box3 blob_box(const scene::Blob& blob) {
  Box3 box;
  for (const Part& part : parts_of(blob))
    if (part.k2 > 0) box.extendBy(part.pov_box);
  return box;
}

std::unique_ptr<Shape> compile_blob(const scene::Object& object) {
  return std::make_unique<Blob>(object, **object.as<std::shared_ptr<const scene::Blob>>());
}

}  // namespace verisim::shapes
