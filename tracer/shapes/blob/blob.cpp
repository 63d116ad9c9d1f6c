// blob (spec 03 4.13): the surface where the fields of spheres and capsules, strength (1 - d^2 / r^2)^2 each, add up to
// the threshold.
//
// A capsule is three parts: a cylinder and two half spheres. Along a ray every part has an interval and a quartic;
// between the ends of intervals the sum is one quartic. All is computed as POV-Ray does it, to the last bit.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <span>

#include "tracer/scene/bounds.h"
#include "tracer/bvh/bvh.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/blob/blob_packet.h"
#include "tracer/shapes/blob/blob_parts.h"
#include "tracer/shapes/blob/blob_intervals.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/scratch.h"
#include "tracer/shapes/rays_within.h"

namespace verisim::shapes {
namespace {

using namespace blob;

constexpr double kNearest = 1e-2, kFarthest = 1e7, kInsideMargin = 1e-6, kElimination = 1e-11;
constexpr std::size_t kFewEvents = 4, kRankedEvents = 48, kManyEvents = 2048;
constexpr std::size_t kMaxTextures = 512;
constexpr int kMinTogether = 3;  // fewer rays are faster one by one

using Part = BlobPart;
using PartKind = BlobPartKind;

class Blob final : public SearchPrimitive<Blob> {
 public:
  Blob(const scene::Object& description, const std::shared_ptr<const scene::Blob>& blob)
      : Blob(description, *blob, BlobParts::of(blob)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    Scratch<Piece> pieces;
    if (!spheres_.empty()) {
      std::uint64_t near = blob_kernels().near(spheres_.data(), spheres_.size(), l.origin, l.direction, 0, 0);
      for (; near != 0; near &= near - 1)
        add_piece(parts_[static_cast<std::size_t>(std::countr_zero(near))], l, pieces);
    } else if (tree_.empty()) {
      for (const Part& part : parts_) add_piece(part, l, pieces);
    } else {
      tree_.traverse({l.origin, l.direction}, 0, HUGE_VAL, [&](std::uint32_t i, double limit) {
        add_piece(parts_[i], l, pieces);
        return limit;
      });
    }
    search(ray, l, pieces, sink, [&] { return add_halves_behind(l, pieces); });
  }

  bool takes_packets() const { return !spheres_.empty() || !tree_.empty(); }
  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    unsigned found = 0;
    double from[RayPacket::kCount];
    std::fill_n(from, RayPacket::kCount, t_min);
    each_search(rays, {from, t_max, true}, [&](int k, auto&& search_ray) {
      NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
      search_ray(sink);
      found |= sink.found() ? 1u << k : 0;
    });
    return found;
  }
  void hits_of_packet(const RayPacket& rays, const double* from, const double* to, LaneHits& hits) const {
    each_search(rays, {from, to, false}, [&](int k, auto&& search_ray) {
      AllHits sink(*this, guards(), hits.begin_lane(k), from[k], to[k]);
      search_ray(sink);
      hits.end_lane(k);
    });
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
      gradient += (-2 * part.k0 * d2 - part.k1) * (part.moved ? part.transform->normal(to_point) : to_point);
    });
    if (gradient == Vec3(0)) return {1, 0, 0};
    // Those of a blob with a matrix are normalised before they go through it, and after.
    return world_normal(has_matrix() ? normalize(gradient) : gradient);
  }

  std::span<const scene::TexturePtr> extra_textures() const override { return textures_; }
  // In single precision throughout, by the reciprocal of the sum, as POV-Ray has them.
  void texture_shares(const Hit& hit, bool, std::vector<TextureShare>& shares) const override {
    float total = 0;
    at(local(hit.point), [&](const Part& part, double d2, const Vec3&) {
      const auto weight = static_cast<float>(std::fabs(field(part, d2)));
      if (weight == 0 || shares.size() >= kMaxTextures) return;
      total += weight;
      const auto c = static_cast<std::size_t>(part.component);
      shares.push_back({textures_[c] ? part.component : -1, weight});
    });
    for (TextureShare& share : shares) share.weight *= 1 / total;
  }

 private:
  Blob(const scene::Object& description, const scene::Blob& blob, std::shared_ptr<const BlobParts> parts)
      : SearchPrimitive(description,
                        {blob.threshold <= 0 ? parts->box : parts->positive_box, blob.threshold > kInsideMargin}),
        threshold_(blob.threshold),
        shared_(std::move(parts)) {
    const auto textured = [](const scene::BlobComponent& c) { return c.texture != nullptr; };
    if (std::any_of(blob.components.begin(), blob.components.end(), textured))
      for (const scene::BlobComponent& c : blob.components) textures_.push_back(c.texture);
  }

  static double field(const Part& part, double d2) { return (part.k0 * d2 + part.k1) * d2 + part.k2; }

  // Squared distance of p from a part's centre or axis; false outside its reach. `to_point` points from there to p, in
  // the part's own space.
  static bool reach(const Part& part, const Vec3& p, double& d2, Vec3& to_point) {
    const Vec3 q = part.moved ? part.transform->inverse_point(p) : p;
    to_point = q - part.center;
    if (part.kind == PartKind::base && to_point.z > 0) return false;
    if (part.kind == PartKind::apex && to_point.z < 0) return false;
    if (part.kind == PartKind::cylinder) {
      if (to_point.z < 0 || to_point.z > part.length) return false;
      to_point.z = 0;
    }
    d2 = dot(to_point, to_point);
    return d2 < part.radius2;
  }

  // The parts that reach a point, from the last to the first, as POV-Ray adds them up.
  template <class Visit>
  void at(const Vec3& p, Visit&& visit) const {
    const auto test = [&](const Part& part) {
      double d2;
      Vec3 to_point;
      if (reach(part, p, d2, to_point)) visit(part, d2, to_point);
    };
    if (tree_.empty()) {
      for (std::size_t i = parts_.size(); i-- > 0;) test(parts_[i]);
      return;
    }
    if (!spheres_.empty()) {
      std::uint64_t around = blob_kernels().around(spheres_.data(), spheres_.size(), p);
      while (around != 0) {
        const int last = std::bit_width(around) - 1;
        test(parts_[static_cast<std::size_t>(last)]);
        around ^= std::uint64_t{1} << last;
      }
      return;
    }
    Scratch<std::uint32_t> around;
    tree_.any_around(p, [&](std::uint32_t i) {
      around.add(i);
      return false;
    });
    around.sort(std::greater<>());
    for (std::size_t i = 0; i < around.size(); ++i) test(parts_[around[i]]);
  }

  struct Limits {
    const double *from, *to;
    bool first;  // only the first hit of each ray is of interest
  };

  // Calls visit(k, search) for the rays that may meet the blob: search(sink) reports the hits of lane k.
  template <class Visit>
  void each_search(const RayPacket& rays, const Limits& limits, Visit&& visit) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.active;
    if (admitted == 0) return;
    LocalPacket l;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, l);
    constexpr std::size_t kMax = 192;
    static_assert(kMax >= BlobParts::kMaxInSpheres);
    PiecePacket met[kMax];
    const std::size_t count = spheres_.empty()
                                  ? blob_kernels().pieces_in_tree(parts_.data(), tree_, l, admitted, met, kMax)
                                  : blob_kernels().pieces(parts_.data(), parts_near(l, admitted), l, admitted, met);
    if (count == 0) return;
    IntervalLists lists;
    const unsigned listed = list_intervals(met, count, l, admitted, limits, lists);
    each_lane(admitted, [&](int k) {
      visit(k, [&](auto& sink) {
        if (count > kMax) return intersections(rays.at(k), sink);
        if (listed >> k & 1 && solve_listed(rays.at(k), l.scale[k], k, lists, limits.first, sink)) return;
        search_alone(rays.at(k), {met, count}, l, k, sink);
      });
    });
  }

  // Lists the intervals of the lanes that may go together; which these are.
  unsigned list_intervals(const PiecePacket* met, std::size_t count, const LocalPacket& l, unsigned lanes,
                          const Limits& limits, IntervalLists& lists) const {
    if (count > IntervalLists::kMaxPieces) return 0;
    // The tree finds parts in any order, and does not look behind the rays.
    const bool by_tree = spheres_.empty();
    if (by_tree && shared_->capsules)
      each_lane(lanes, [&](int k) {
        if (accel::contains(shared_->box, {l.ox[k], l.oy[k], l.oz[k]})) lanes &= ~(1u << k);
      });
    std::array<const PiecePacket*, IntervalLists::kMaxPieces> ordered;
    for (std::size_t i = 0; i < count; ++i) {
      const PiecePacket& p = met[i];
      std::size_t at = i;
      for (; by_tree && at > 0 && p.part < ordered[at - 1]->part; --at) ordered[at] = ordered[at - 1];
      ordered[at] = &p;
      lanes &= ~p.behind;
      each_lane(p.met & lanes, [&](int k) { lanes &= p.t1[k] < kNearest ? ~(1u << k) : ~0u; });
    }
    if (std::popcount(lanes) < kMinTogether) return 0;
    blob_kernels().intervals(ordered.data(), count, l, lanes,
                             {threshold_, too_near_of_rays(), limits.from, limits.to, limits.first}, lists);
    return lanes;
  }

  // False: there may be more than what is listed.
  template <class Sink>
  bool solve_listed(const Ray& ray, double scale, int k, const IntervalLists& lists, bool first, Sink& sink) const {
    for (const IntervalPacket& p : std::span(lists.intervals, lists.count)) {
      if (!(p.lanes >> k & 1)) continue;
      Interval interval{lists.start[k], lists.span[k], scale, p.from[k], p.to[k], {}};
      for (int i = 0; i < 5; ++i) interval.power[i] = p.power[i][k];
      if (solve(ray, interval, sink)) {
        if (Sink::kNearest) return true;
      } else if (first) {
        return false;
      }
    }
    return true;
  }

  template <class Sink>
  void search_alone(const Ray& ray, std::span<const PiecePacket> met, const LocalPacket& l, int k, Sink& sink) const {
    const LocalRay local{{l.ox[k], l.oy[k], l.oz[k]}, {l.dx[k], l.dy[k], l.dz[k]}, l.scale[k]};
    Scratch<Piece> pieces;
    const auto piece_of = [k](const PiecePacket& p) {
      return RayPiece{p.t0[k], p.t1[k], p.scale2[k], p.peak[k], p.whole_end[k]};
    };
    for (const PiecePacket& p : met)
      if (p.met >> k & 1) add_piece(*p.part, piece_of(p), pieces);
    search(ray, local, pieces, sink, [&] {
      if (spheres_.empty()) return add_halves_behind(local, pieces);  // the tree does not look behind
      const std::size_t before = pieces.size();
      for (const PiecePacket& p : met)
        if (p.behind >> k & 1) add_half_behind(*p.part, piece_of(p), pieces);
      return pieces.size() > before;
    });
  }

  static void add_piece(const Part& part, const LocalRay& l, Scratch<Piece>& pieces) {
    RayPiece p;
    if (blob_kernels().piece(part, l.origin, l.direction, p) && p.t1 > 0) add_piece(part, p, pieces);
  }
  static void add_piece(const Part& part, const RayPiece& p, Scratch<Piece>& pieces) {
    if (p.t1 < kNearest && ends_too_near(part, p)) return;
    Piece& piece = pieces.add();
    piece.t0 = std::max(0.0, p.t0), piece.t1 = p.t1, piece.part = &part, piece.scale2 = p.scale2, piece.peak = p.peak;
  }

  static bool is_half(const Part& part) { return part.kind == PartKind::base || part.kind == PartKind::apex; }
  // Spheres and walls of capsules that end before the first hit may lie are none to POV-Ray; half spheres are.
  static bool ends_too_near(const Part& part, const RayPiece& p) {
    return !is_half(part) && !RaysWithin::now() && p.whole_end < kNearest;
  }

  // Some of a sphere, which no more than rounding makes smaller than the part.
  static bool may_lie_behind(const PartSpheres& spheres, std::size_t i, const LocalRay& l) {
    const Vec3 to(spheres.x[i] - l.origin.x, spheres.y[i] - l.origin.y, spheres.z[i] - l.origin.z);
    return dot(to, l.direction) < 0 || dot(to, to) <= 1.001 * spheres.radius[i] * spheres.radius[i];
  }

  // Half spheres behind a ray, through which its line passes, are pieces of no length at its start to POV-Ray, added
  // and taken away again: it shows in the last digits of the running sum. They come in the order of the line, but
  // where the plane ends them that is at the start itself. True: there are any.
  static void add_half_behind(const Part& part, const RayPiece& line, Scratch<Piece>& pieces) {
    Piece& piece = pieces.add();
    piece = Piece();
    piece.t0 = line.t0, piece.t1 = line.t1 < line.whole_end ? 0 : line.t1, piece.part = &part;
  }
  bool add_halves_behind(const LocalRay& l, Scratch<Piece>& pieces) const {
    if (!accel::contains(shared_->box, l.origin)) return false;  // all is before the ray, or nothing
    const std::size_t before = pieces.size();
    const auto add = [&](const Part& part) {
      RayPiece line;
      if (is_half(part) && blob_kernels().piece(part, l.origin, l.direction, line) && line.t1 <= 0)
        add_half_behind(part, line, pieces);
    };
    if (!spheres_.empty()) {
      std::uint64_t near = blob_kernels().near(spheres_.data(), spheres_.size(), l.origin, l.direction, 0, 0);
      near &= shared_->halves;
      for (; near != 0; near &= near - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(near));
        if (may_lie_behind(spheres_[i / 8], i % 8, l)) add(parts_[i]);
      }
    } else if (tree_.empty()) {
      for (const Part& part : parts_) add(part);
    } else {
      tree_.traverse({l.origin, -1.0 * l.direction}, 0, HUGE_VAL, [&](std::uint32_t i, double limit) {
        add(parts_[i]);
        return limit;
      });
    }
    return pieces.size() > before;
  }

  // What the running sum over so long a way may be off by: the coefficients of thin parts are huge.
  static double rounding_of(const Scratch<Piece>& pieces, double span) {
    double sum = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double size = 1 + pieces[i].scale2 * span * span;
      sum += std::fabs(pieces[i].part->k2) * size * size;
    }
    return 1e-12 * sum;
  }

  template <class Use>
  static void each_event(const Scratch<Piece>& pieces, Use&& use) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = pieces[i];
      use(Event{piece.t0, static_cast<std::int32_t>(i), true, piece.part});
      use(Event{piece.t1, static_cast<std::int32_t>(i), false, piece.part});
    }
  }
  // Puts an event into its place among those in order before `end`.
  static void insert(const Event& event, Event* list, Event* end) {
    for (; end > list && event < end[-1]; --end) *end = end[-1];
    *end = event;
  }
  // Writes the ends of pieces section by section of the way, which lies between `start` and start + span.
  static void write_by_sections(const Scratch<Piece>& pieces, double start, double span, Event* list) {
    constexpr std::size_t kMax = 1024;
    const std::size_t sections = std::min(kMax, std::bit_ceil(4 * pieces.size()));  // so many that few ends share one
    const double scale = std::min(static_cast<double>(sections - 1) / span, 1e300);
    const auto section = [&](double t) { return static_cast<std::size_t>(std::max(t - start, 0.0) * scale); };
    std::uint16_t next[kMax + 1];
    std::fill_n(next, sections + 1, std::uint16_t{0});
    for (std::size_t i = 0; i < pieces.size(); ++i)
      ++next[section(pieces[i].t0) + 1], ++next[section(pieces[i].t1) + 1];
    for (std::size_t i = 1; i < sections; ++i) next[i] = static_cast<std::uint16_t>(next[i] + next[i - 1]);
    each_event(pieces, [&](const Event& event) { list[next[section(event.t)]++] = event; });
  }

  // The same in order, but for those at one place.
  static void write_by_ranks(const Scratch<Piece>& pieces, Event* list) {
    alignas(64) double ends[kRankedEvents], places[kRankedEvents];
    std::size_t count = 0;
    each_event(pieces, [&](const Event& event) { ends[count++] = event.t; });
    blob_kernels().ranks(ends, static_cast<int>(count), places);
    count = 0;
    each_event(pieces, [&](const Event& event) { list[static_cast<std::size_t>(places[count++])] = event; });
  }

  // The ends of pieces, from near to far.
  static void add_events(const Scratch<Piece>& pieces, double start, double span, Scratch<Event>& events) {
    const std::size_t count = 2 * pieces.size();
    Event *const list = events.add_many(count), *end = list;
    if (count <= kFewEvents) {
      each_event(pieces, [&](const Event& event) { insert(event, list, end++); });
    } else if (count <= kManyEvents) {
      if (count <= kRankedEvents)
        write_by_ranks(pieces, list);
      else
        write_by_sections(pieces, start, span, list);
      for (; end < list + count; ++end)
        if (end > list && *end < end[-1]) insert(Event(*end), list, end);
    } else {
      each_event(pieces, [&](const Event& event) { *end++ = event; });
      std::sort(list, end);
    }
  }

  // The hits of a ray that its sink asks for, interval by interval.
  // `add_behind` adds the half spheres behind the ray, if there are any.
  template <class Sink, class AddBehind>
  void search(const Ray& ray, const LocalRay& l, Scratch<Piece>& pieces, Sink& sink, AddBehind&& add_behind,
              bool all_pieces = false) const {
    double start = HUGE_VAL, end = -HUGE_VAL, peak = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      start = std::min(start, std::max(pieces[i].t0, 0.0)), end = std::max(end, pieces[i].t1);
      peak += pieces[i].peak;
    }
    const double span = end - start;
    if (!(span > 0 && std::isfinite(span))) return;
    const double rounding = rounding_of(pieces, span);
    if (field::stays_below(peak, threshold_, rounding)) return;
    Scratch<Event> events;
    add_events(pieces, start, span, events);
    Intervals intervals(l, &events[0], events.size(), &pieces[0], threshold_);
    const double too_near = (too_near_of_rays() * l.scale - start) / span;
    while (intervals.next()) {
      if (intervals.depth(intervals.from) > sink.upper()) return;
      if (intervals.depth(intervals.to) < sink.lower()) continue;
      if (intervals.to < too_near || field::stays_below(intervals.peak, threshold_, rounding)) continue;
      if (field::keeps_its_sign(intervals.power, intervals.from, intervals.to)) continue;
      if (intervals.from < too_near && field::keeps_its_sign_by_far(intervals.power, too_near, intervals.to)) continue;
      // What lies behind is looked for where it may matter: few rays come to here.
      if (!all_pieces && shared_->capsules && add_behind()) return search(ray, l, pieces, sink, add_behind, true);
      all_pieces = true;
      if (solve(ray, intervals, sink) && Sink::kNearest) return;
    }
  }

  // Hits nearer than this are none, but for searches from within.
  static double nearest() { return RaysWithin::now() ? 1e-7 : kNearest; }
  static double too_near_of_rays() { return 0.5 * nearest(); }

  // True: a hit was accepted.
  template <class Sink>
  bool solve(const Ray& ray, const Interval& interval, Sink& sink) const {
    const double* p = interval.power;
    const double c[5] = {p[4], p[3], p[2], p[1], p[0]};
    double roots[4];
    const int n = solve_polynomial(4, c, roots, object->sturm, kElimination, interval.from, interval.to);
    std::sort(roots, roots + n);
    bool found = false;
    for (int i = 0; i < n; ++i)
      if (roots[i] >= interval.from && roots[i] <= interval.to && report(ray, interval, roots[i], sink)) {
        found = true;
        if (Sink::kNearest) break;
      }
    return found;
  }

  template <class Sink>
  static bool report(const Ray& ray, const Interval& interval, double root, Sink& sink) {
    const double depth = interval.depth(root);
    return depth > nearest() && depth < kFarthest &&
           sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
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

  double threshold_;
  const std::shared_ptr<const BlobParts> shared_;
  const std::vector<Part>& parts_ = shared_->parts;
  const std::vector<PartSpheres>& spheres_ = shared_->spheres;
  const accel::Bvh& tree_ = shared_->tree;
  std::vector<scene::TexturePtr> textures_;
};

}  // namespace

Box3 blob_box(const scene::Blob& blob) {
  Box3 box;
  const PartList list = parts_of(blob);
  for (std::size_t i = 0; i < list.parts.size(); ++i)
    if (list.parts[i].k2 > 0) box.extendBy(list.reaches[i].pov_box);
  // Numbers, not infinities: turned round by a transformation POV-Ray's empty box holds everything (spec 03 4.13).
  if (box.isEmpty()) box.min = Vec3(2 * scene::kBoxLimit), box.max = Vec3(-2 * scene::kBoxLimit);
  return box;
}

std::unique_ptr<Shape> compile_blob(const scene::Object& object) {
  return std::make_unique<Blob>(object, *object.as<std::shared_ptr<const scene::Blob>>());
}

}  // namespace verisim::shapes
