// blob (spec 03 4.13): the surface where the fields of spheres and capsules, strength (1 - d^2 / r^2)^2 each, add up to
// the threshold.
//
// A capsule is three parts: a cylinder and two half spheres. Along a ray every part has an interval and a quartic;
// between the ends of intervals the sum is one quartic, whose roots are isolated by its Bernstein coefficients.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>

#include "tracer/bvh/bvh.h"
#include "tracer/math/bernstein_packet.h"
#include "tracer/shapes/blob/blob_packet.h"
#include "tracer/shapes/blob/blob_parts.h"
#include "tracer/shapes/blob/blob_intervals.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/scratch.h"

namespace verisim::shapes {
namespace {

using namespace blob;

constexpr double kNearest = 1e-2, kFarthest = 1e7, kInsideMargin = 1e-6;
constexpr std::size_t kFewPieces = 24;
constexpr std::size_t kMaxTextures = 512;

using Part = BlobPart;
using PartKind = BlobPartKind;

class Blob final : public Primitive<Blob> {
 public:
  Blob(const scene::Object& description, const std::shared_ptr<const scene::Blob>& blob)
      : Blob(description, *blob, BlobParts::of(blob)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
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
    if (pieces.size() == 0 || misses(pieces)) return;
    Scratch<Event> events;
    add_events(pieces, 0, events);
    Scratch<std::int32_t> active;
    for (std::size_t i = 0; i < pieces.size(); ++i) active.add(0);
    Intervals intervals(&events[0], events.size(), &active[0]);
    if (!intervals.valid()) return;
    while (intervals.next()) {
      double power[5], roots[4];
      if (!sum_pieces(&pieces[0], intervals, power)) continue;
      const int n = bernstein_roots<4>(power, intervals.from, intervals.to, roots);
      for (int i = 0; i < n; ++i)
        if (report(ray, l.scale, intervals, roots[i], sink) && Sink::kNearest) return;
    }
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (spheres_.empty()) return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    return nearest_of_packet(
        rays, t_min, t_max, [&](int k) -> Hit& { return hits[k]; }, false);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (spheres_.empty()) return Shape::occludes_packet(rays, entry, t_min, t_max);
    Hit hit;
    return nearest_of_packet(
        rays, t_min, t_max, [&](int) -> Hit& { return hit; }, true);
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    double sum = 0;
    at(p, [&](const Part& part, double d2, const Vec3&) { sum += field(part, d2); });
    return sum > threshold_ - kInsideMargin;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 p = local(hit.point);
    Vec3 gradient(0);
    at(p, [&](const Part& part, double d2, const Vec3& to_point) {
      const Vec3 g = -2 * (2 * part.k0 * d2 + part.k1) * to_point;
      gradient += part.moved ? part.transform->normal(g) : g;
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
  Blob(const scene::Object& description, const scene::Blob& blob, std::shared_ptr<const BlobParts> parts)
      : Primitive(description, {box_of(parts->parts, blob.threshold <= 0), blob.threshold > kInsideMargin}),
        threshold_(blob.threshold),
        shared_(std::move(parts)) {
    const auto textured = [](const scene::BlobComponent& c) { return c.texture != nullptr; };
    if (std::any_of(blob.components.begin(), blob.components.end(), textured))
      for (const scene::BlobComponent& c : blob.components) textures_.push_back(c.texture);
  }

  static double field(const Part& part, double d2) { return (part.k0 * d2 + part.k1) * d2 + part.k2; }

  // Squared distance of p from a part's centre or axis; false outside its reach. `to_point` points from there to p, in
  // the component's own space.
  static bool reach(const Part& part, const Vec3& p, double& d2, Vec3& to_point) {
    const Vec3 q = part.moved ? part.transform->inverse_point(p) : p;
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
    if (!order_.empty()) {
      for (std::uint64_t around = blob_kernels().around(ordered_spheres_.data(), ordered_spheres_.size(), p);
           around != 0; around &= around - 1)
        test(parts_[order_[static_cast<std::size_t>(std::countr_zero(around))]]);
      return;
    }
    tree_.any_around(p, [&](std::uint32_t i) {
      test(parts_[i]);
      return false;
    });
  }

  // The interval of the ray within a part's reach.
  static void add_piece(const Part& part, const LocalRay& l, Scratch<Piece>& pieces) {
    Vec3 o = l.origin, d = l.direction;
    if (part.moved) o = part.transform->inverse_point(o), d = part.transform->inverse_direction(d);
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
    if (part.k2 > 0)
      piece.peak = piece.a > kEpsilon ? field(part, std::max(piece.c - piece.b * piece.b / piece.a, 0.0)) : part.k2;
    pieces.add(piece);
  }

  // Fields that add up to no more than `peak` do not reach the threshold, whatever the rounding.
  bool misses(double peak) const { return peak < threshold_ - 1e-6 * (1 + std::fabs(threshold_)); }
  bool misses(const Scratch<Piece>& pieces) const {
    double peak = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) peak += pieces[i].peak;
    return misses(peak);
  }

  // The ends of pieces from `first` on, whose numbers count from there.
  static void add_events(const Scratch<Piece>& pieces, std::size_t first, Scratch<Event>& events) {
    for (std::size_t i = first; i < pieces.size(); ++i) {
      events.insert_sorted({pieces[i].t0, static_cast<std::int32_t>(i - first), true}, kFewPieces);
      events.insert_sorted({pieces[i].t1, static_cast<std::int32_t>(i - first), false}, kFewPieces);
    }
    if (events.size() > kFewPieces) events.sort();
  }

  // The field less the threshold on a interval, in powers of the rescaled parameter; false: it does not reach it.
  bool sum_pieces(Piece* pieces, const Intervals& intervals, double* power) const {
    double peak = 0;
    for (const std::int32_t i : intervals.active()) peak += pieces[i].peak;
    if (misses(peak)) return false;
    power[0] = -threshold_, power[1] = power[2] = power[3] = power[4] = 0;
    for (const std::int32_t n : intervals.active()) {
      Piece& piece = pieces[n];
      if (!piece.expanded) expand(piece, intervals.start, intervals.span);
      for (int i = 0; i < 5; ++i) power[i] += piece.power[i];
    }
    return true;
  }

  template <class Sink>
  static bool report(const Ray& ray, double scale, const Intervals& intervals, double root, Sink& sink) {
    const double depth = (intervals.start + intervals.span * root) / scale;
    // Searches from within (subsurface scattering) ask for everything in front, and POV-Ray's own leave nothing out
    // there.
    const double nearest = Sink::kNearest && sink.lower() == std::numeric_limits<double>::min() ? 1e-7 : kNearest;
    return depth > nearest && depth < kFarthest && sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
  }

  // The parts that any of several rays may meet.
  std::uint64_t parts_near(const LocalPacket& l, unsigned lanes) const {
    const int one = std::countr_zero(lanes);
    const auto origin = [&](int k) { return Vec3(l.ox[k], l.oy[k], l.oz[k]); };
    const auto direction = [&](int k) { return Vec3(l.dx[k], l.dy[k], l.dz[k]); };
    double apart2 = 0, bent2 = 0, size2 = HUGE_VAL;
    bool strange = false;  // NaN: any part may be near
    each_lane(lanes, [&](int k) {
      const Vec3 o = origin(k) - origin(one), d = direction(k) - direction(one);
      const double a = dot(o, o), b = dot(d, d), c = dot(direction(k), direction(k));
      apart2 = std::max(apart2, a), bent2 = std::max(bent2, b), size2 = std::min(size2, c);
      strange = strange || !(a < HUGE_VAL && b < HUGE_VAL && c > 0);
    });
    return blob_kernels().near(spheres_.data(), spheres_.size(), origin(one), direction(one),
                               strange ? HUGE_VAL : std::sqrt(apart2), std::sqrt(bent2 / size2));
  }

  // Events at one place: their order, and with it the order of sums, is that in which the tree finds the parts.
  static bool any_together(const Scratch<Event>& events) {
    for (std::size_t i = 1; i < events.size(); ++i)
      if (events[i].t == events[i - 1].t) return true;
    return false;
  }

  // A ray of several, and its part of the lists that they share.
  struct PacketSearch {
    std::size_t first_piece, first_event, events;
    double scale;
    std::optional<Intervals> intervals;
  };

  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.active;
    if (admitted == 0) return 0;
    LocalPacket lanes;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, lanes);
    PiecePacket met[BlobParts::kMaxForPacket];
    const std::size_t count = blob_kernels().pieces(parts_.data(), parts_near(lanes, admitted), lanes, admitted, met);
    if (count == 0) return 0;
    Scratch<Piece> pieces;
    Scratch<Event, PacketSearch> events;
    Scratch<std::int32_t> active;
    PacketSearch searches[RayPacket::kCount];
    unsigned open = 0, apart = 0;
    each_lane(admitted, [&](int k) {
      PacketSearch& search = searches[k];
      search = {pieces.size(), events.size(), 0, lanes.scale[k], {}};
      double peak = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const PiecePacket& p = met[i];
        if (!(p.met >> k & 1)) continue;
        pieces.add({p.t0[k], p.t1[k], p.a[k], p.b[k], p.c[k], p.part, p.peak[k]});
        peak += p.peak[k];
      }
      if (pieces.size() == search.first_piece || misses(peak)) return;
      Scratch<Event> sorted;
      add_events(pieces, search.first_piece, sorted);
      if (!tree_.empty() && any_together(sorted)) {
        apart |= 1u << k;
        return;
      }
      search.events = sorted.size();
      for (std::size_t i = 0; i < sorted.size(); ++i) events.add(sorted[i]);
      open |= 1u << k;
    });
    for (std::size_t i = 0; i < pieces.size(); ++i) active.add(0);
    each_lane(open, [&](int k) {
      PacketSearch& search = searches[k];
      search.intervals.emplace(&events[search.first_event], search.events, &active[search.first_piece]);
      if (!search.intervals->valid()) open &= ~(1u << k);
    });

    unsigned found = 0;
    each_lane(apart, [&](int k) {
      NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
      intersections(rays.at(k), sink);
      found |= sink.found() ? 1u << k : 0;
    });
    // Every lane goes from interval to interval until it is hit; those of all lanes are solved together.
    RootPacket roots;
    while (open != 0) {
      unsigned solved = 0;
      each_lane(open, [&](int k) {
        PacketSearch& search = searches[k];
        Intervals& intervals = *search.intervals;
        double power[5];
        do {
          if (!intervals.next() || (intervals.start + intervals.span * intervals.from) / search.scale >= t_max[k]) {
            open &= ~(1u << k);
            return;
          }
        } while (!sum_pieces(&pieces[search.first_piece], intervals, power));
        for (int i = 0; i < 5; ++i) roots.power[i][k] = power[i];
        roots.from[k] = intervals.from, roots.to[k] = intervals.to;
        solved |= 1u << k;
      });
      if (solved != 0) solved = bernstein_kernels().begin(4, solved, roots);
      while (solved != 0) {
        solved &= bernstein_kernels().next(4, solved, roots);
        each_lane(solved, [&](int k) {
          NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
          if (report(rays.at(k), searches[k].scale, *searches[k].intervals, roots.root[k], sink)) {
            found |= 1u << k;
            open &= ~(1u << k), solved &= ~(1u << k);
          }
        });
      }
    }
    return found;
  }

  static void expand(Piece& piece, double start, double span) {
    const Part& part = *piece.part;
    const double a = piece.a * span * span, b = 2 * (piece.b + piece.a * start) * span,
                 c = piece.c + start * (2 * piece.b + start * piece.a);
    piece.power[4] = part.k0 * a * a;
    piece.power[3] = part.k0 * 2 * a * b;
    piece.power[2] = part.k0 * (b * b + 2 * a * c) + part.k1 * a;
    piece.power[1] = part.k0 * 2 * b * c + part.k1 * b;
    piece.power[0] = field(part, c);
    piece.expanded = true;
  }

  double threshold_;
  const std::shared_ptr<const BlobParts> shared_;
  const std::vector<Part>& parts_ = shared_->parts;
  const std::vector<PartSpheres>& spheres_ = shared_->spheres;
  const std::vector<std::uint32_t>& order_ = shared_->order;
  const std::vector<PartSpheres>& ordered_spheres_ = shared_->ordered_spheres;
  const accel::Bvh& tree_ = shared_->tree;
  std::vector<scene::TexturePtr> textures_;
};

}  // namespace

Box3 blob_box(const scene::Blob& blob) {
  Box3 box;
  std::vector<Box3> boxes;
  const std::vector<Part> parts = parts_of(blob, &boxes);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].k2 > 0) box.extendBy(boxes[i]);
  return box;
}

std::unique_ptr<Shape> compile_blob(const scene::Object& object) {
  return std::make_unique<Blob>(object, *object.as<std::shared_ptr<const scene::Blob>>());
}

}  // namespace verisim::shapes
