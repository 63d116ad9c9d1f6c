// isosurface (spec 04 section 6).
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "tracer/functions/function.h"
#include "tracer/shapes/implicit/container.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/implicit/isosurface_batch.h"
#include "tracer/shapes/implicit/isosurface_findings.h"
#include "tracer/shapes/implicit/isosurface_search.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

namespace {

constexpr double kFarthest = 2e10;

// Normals that a thread computed for eight hits together, until they are asked for. An entry is found by the place in
// Hit::u, and then compared.
struct NormalMemory {
  struct Entry {
    std::uint64_t shape = 0;
    double point[3] = {}, normal[3] = {};
  };
  static constexpr int kCount = 2 * RayBatch::kSize;

  const Entry* find(const Hit& hit, std::uint64_t shape) const {
    const Entry& entry = entries[static_cast<int>(hit.u)];
    return hit.part == 0 && entry.shape == shape && std::memcmp(entry.point, &hit.point, sizeof entry.point) == 0
               ? &entry
               : nullptr;
  }
  int add(const Entry& entry) {
    next = (next + 1) % kCount;
    entries[next] = entry;
    return next;
  }
  Entry entries[kCount] = {};
  int next = 0;
};
constinit thread_local NormalMemory normals_of_thread;
constinit thread_local LastMiss miss_of_thread;
std::atomic<std::uint64_t> isosurfaces_made{0};

}  // namespace

LastMiss& last_miss() { return miss_of_thread; }
void exchange_last_miss(LastMiss::Search& other) { std::swap(other.isosurface, miss_of_thread.last.isosurface); }

namespace {

class Isosurface final : public Primitive<Isosurface> {
 public:
  Isosurface(const scene::Object& description, const scene::Isosurface& s)
      : Primitive(description, {container_box(s.container), true}), surface_(s), max_gradient_(s.max_gradient) {
    max_trace_ = s.max_trace <= 0 || s.max_trace > kMaxTraced ? kMaxTraced : s.max_trace;
    const bool plain = !s.evaluate && description.clipped_by.empty() && description.bounded_by.empty();
    if (plain) in_batches_ = FieldPacket::suitable(s.function.get());
    if (!s.evaluate) field_.narrowing = functions::Narrowing::of(s.function.get());
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    if (field_.narrowing && !last_miss().kept)
      intersections_by<BoundedValue>(ray, sink);
    else
      intersections_by<ExactValue>(ray, sink);
  }
  template <class Value, class Sink>
  void intersections_by(const Ray& ray, Sink& sink) const {
    IsosurfaceSearch<Value> search{field_,
                                   ray.origin,
                                   ray.direction,
                                   0,
                                   1,
                                   0,
                                   steepest_.load(std::memory_order_relaxed),
                                   number_,
                                   last_miss().kept ? &last_miss() : nullptr};
    if (has_matrix())
      search.origin = matrix().inverse_point(ray.origin), search.direction = matrix().inverse_direction(ray.direction);
    search.speed = length(search.direction);
    const double before = search.gradient =
        surface_.evaluate ? adapted_gradient_.load(std::memory_order_relaxed) : max_gradient_;
    if (!trace(ray, search, sink)) return;
    raise(steepest_, search.steepest);
    if (!surface_.evaluate) return;
    raise(adapted_gradient_, search.gradient);
    if (!sink.any()) {  // shadow rays do not count
      raise(largest_raise_, search.gradient - before);
      rays_.fetch_add(1, std::memory_order_relaxed);
      add(sum_of_gradients_, search.gradient);
    }
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const final {
    if (!in_batches_ || std::popcount(rays.active) < kMin || last_miss().kept)
      return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    BatchHits batch(t_min, t_max, false);
    FieldPacket field(*in_batches_);
    trace_batch(rays, batch, field);
    each_lane(batch.found,
              [&](int k) { hits[k] = {batch.t_max[k], rays.at(k).at(batch.t_max[k]), this, batch.face[k], 0, 0}; });
    remember_normals(batch.found, hits);
    return batch.found | Shape::intersect_packet({rays.rays, rays.first, batch.alone}, entry, kind, t_min, t_max, hits);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const final {
    if (!in_batches_ || std::popcount(rays.active) < kMin || last_miss().kept)
      return Shape::occludes_packet(rays, entry, t_min, t_max);
    BatchHits batch(t_min, t_max, true);
    FieldPacket field(*in_batches_);
    trace_batch(rays, batch, field);
    return batch.found | Shape::occludes_packet({rays.rays, rays.first, batch.alone}, entry, t_min, t_max);
  }

  void intersect_packet_between(const RayPacket& rays, RayKind kind, const double* from, const double* to,
                                LaneHits& hits) const final {
    // Functions that are called are called for idle lanes, too.
    const int least = in_batches_ && !in_batches_->calls().empty() ? 6 : kMin;
    if (!in_batches_ || std::popcount(rays.active) < least || last_miss().kept)
      return Shape::intersect_packet_between(rays, kind, from, to, hits);
    EveryHit every;
    BatchHits batch(-HUGE_VAL, to, false, &every);
    FieldPacket field(*in_batches_);
    trace_batch(rays, batch, field);
    each_lane(rays.active & ~batch.alone, [&](int k) {
      HitList& list = hits.begin_lane(k);
      for (int i = 0; i < every.count[k]; ++i)
        list.push_back({every.t[k][i], rays.at(k).at(every.t[k][i]), this, every.face[k][i], 0, 0});
      hits.end_lane(k);
    });
    Shape::intersect_packet_between({rays.rays, rays.first, batch.alone}, kind, from, to, hits);
  }

  std::string finding() const final {
    if (!surface_.evaluate) return max_gradient_finding(steepest_, max_gradient_);
    return rays_ == 0 ? std::string()
                      : evaluate_finding(*surface_.evaluate, adapted_gradient_, largest_raise_,
                                         sum_of_gradients_ / static_cast<double>(rays_));
  }

  bool contains(const Vec3& p) const {
    const Vec3 q = local(p);
    return in_container(surface_.container, q) && !(field_.value(q) - surface_.threshold > 0);
  }

  Vec3 geometric_normal(const Hit& hit) const {
    if (const NormalMemory::Entry* known = normals_of_thread.find(hit, number_))
      return {known->normal[0], known->normal[1], known->normal[2]};
    const Vec3 p = local(hit.point);
    if (hit.part > 0) return world_normal(container_normal(surface_.container, hit.part, p));
    const auto& container = surface_.container;
    if (on_shell(p)) return world_normal(container_normal(container, 7, p));
    const double a = surface_.accuracy;
    const double points[3][4] = {{p.x, p.x + a, p.x, p.x}, {p.y, p.y, p.y + a, p.y}, {p.z, p.z, p.z, p.z + a}};
    double f[4];
    surface_.function->evaluate_batch(points[0], 4, 4, f);
    const Vec3 gradient(f[1] - f[0], f[2] - f[0], f[3] - f[0]);
    if (gradient.x == 0 && gradient.y == 0 && gradient.z == 0) return world_normal({1, 0, 0});
    return world_normal(normalize(gradient));
  }

 private:
  // What counts as a hit on a spherical container, whatever was hit.
  bool on_shell(const Vec3& p) const {
    const auto& container = surface_.container;
    return container.sphere && std::fabs(length(p - container.center) - container.radius) < kEpsilon;
  }

  // False: the container is missed.
  template <class Value, class Sink>
  bool trace(const Ray& ray, IsosurfaceSearch<Value>& search, Sink& sink) const;
  template <class Value, class Sink>
  void trace(const Ray& ray, IsosurfaceSearch<Value>& search, const ContainerSpan& span, Sink& sink) const;

  static constexpr int kMaxTraced = 10;
  // Of eight rays, in the order in which they are found.
  struct EveryHit {
    double t[RayPacket::kCount][1 + kMaxTraced];  // the first of them may be on the container
    int face[RayPacket::kCount][1 + kMaxTraced];
    int count[RayPacket::kCount] = {};
  };
  // The nearest hits of eight rays, or any, as NearestHit keeps them for one; or every hit.
  struct BatchHits {
    BatchHits(double min, const double* max, bool any_will_do, EveryHit* all = nullptr)
        : t_min(min), limit(max), any(any_will_do), every(all) {
      std::copy_n(max, RayPacket::kCount, t_max);
    }
    double t_min;
    const double* limit;
    bool any;
    EveryHit* every;  // null: the nearest hits
    double t_max[RayPacket::kCount];
    int face[RayPacket::kCount];
    unsigned found = 0;
    unsigned alone = 0;  // lanes that are not to be searched with others

    void forget(unsigned lanes) {
      if (every) each_lane(lanes, [&](int k) { every->count[k] = 0; });
      each_lane(lanes & found, [&](int k) { t_max[k] = limit[k]; });
      found &= ~lanes;
    }
    // Whether the ray need not go on.
    bool add(int k, double t, int at_face) {
      if (every) {
        const int place = every->count[k]++;
        every->t[k][place] = t, every->face[k][place] = at_face;
        return false;
      }
      const bool again = found >> k & 1;
      if (!(t >= t_min) || !(again ? t <= t_max[k] : t < t_max[k])) return false;
      t_max[k] = t, face[k] = at_face;
      found |= 1u << k;
      return true;
    }
  };
  // `trace` for eight rays.
  class BatchTrace;
  void trace_batch(const RayPacket& rays, BatchHits& hits, FieldPacket& field) const;
  const Affine* to_object() const { return has_matrix() ? &matrix().inv : nullptr; }
  void remember_normals(unsigned found, Hit* hits) const;

  static void raise(std::atomic<double>& largest, double v) {
    double known = largest.load(std::memory_order_relaxed);
    while (v > known && !largest.compare_exchange_weak(known, v, std::memory_order_relaxed)) {
    }
  }
  static void add(std::atomic<double>& sum, double v) {
    double known = sum.load(std::memory_order_relaxed);
    while (!sum.compare_exchange_weak(known, known + v, std::memory_order_relaxed)) {
    }
  }
  const std::uint64_t number_ = ++isosurfaces_made;
  scene::Isosurface surface_;
  IsosurfaceField field_{surface_, nullptr};
  double max_gradient_;
  int max_trace_;
  static constexpr int kMin = 3;                    // rays that are searched in step
  const functions::Program* in_batches_ = nullptr;  // null: rays are searched one by one
  // Made for those that have many rays to search.
  const CurvatureMap* map() const {
    constexpr int kRowsWithout = 200;
    const CurvatureMap* const made = map_.load(std::memory_order_acquire);
    if (made) return made->useful() ? made : nullptr;
    if (batches_.fetch_add(1, std::memory_order_relaxed) == kRowsWithout) {
      own_map_ = std::make_unique<CurvatureMap>(*in_batches_, container_box(surface_.container));
      map_.store(own_map_.get(), std::memory_order_release);
    }
    return nullptr;
  }
  mutable std::atomic<int> batches_{0}, doubts_{0};
  mutable std::unique_ptr<const CurvatureMap> own_map_;
  mutable std::atomic<const CurvatureMap*> map_{nullptr};
  // `evaluate`: the largest slope any ray needed so far (spec 04 6.4).
  mutable std::atomic<double> adapted_gradient_{surface_.max_gradient};
  // What the rays found, for the author of the scene (spec 04 6.7).
  mutable std::atomic<double> steepest_{0}, largest_raise_{0}, sum_of_gradients_{0};
  mutable std::atomic<std::uint64_t> rays_{0};
};

template <class Value, class Sink>
bool Isosurface::trace(const Ray& ray, IsosurfaceSearch<Value>& search, Sink& sink) const {
  ContainerSpan span;
  if (!intersect_container(surface_.container, search.origin, search.direction, span)) return false;
  trace(ray, search, span, sink);
  return true;
}

template <class Value, class Sink>
void Isosurface::trace(const Ray& ray, IsosurfaceSearch<Value>& search, const ContainerSpan& span, Sink& sink) const {
  const double a = surface_.accuracy, gap = 5 * a, near_zero = 4 * search.gradient * a;
  double begin = std::max(span.enter, 0.0), end = span.leave;
  const auto report = [&](double t, int face) {
    return sink.add(
        t, [&] { return ray.at(t); }, face);
  };
  const auto start_behind_surface = [&] {
    begin = gap;
    if (search.below(gap, 0)) search.sign = -1;
  };

  int remaining = max_trace_;
  double wall = -1;  // a hit on the container
  int wall_face = 0;
  if (!surface_.open) {
    if (begin > a) {
      // Cut away, it is as if the wall had not been met: it uses up none of the hits either.
      if (search.below(begin, 0) && !sink.clipped(ray.at(begin))) {
        --remaining;
        wall = begin, wall_face = span.enter_face, search.sign = -1;
      }
    } else {
      if (search.below(begin, near_zero)) start_behind_surface();
      if (search.below(end, 0)) wall = end, wall_face = span.leave_face;
    }
  }
  end = std::min(end, kFarthest);
  if (!(end - begin >= a)) return;
  // What is searched behind the nearest hit is remembered, too.
  const bool ends_with_nearest = Sink::kNearest && !search.memory;
  if (wall >= 0 && report(wall, wall_face) && ends_with_nearest && wall == begin) return;
  if (begin < a && search.sign > 0 && search.end_field(begin).near_zero(search, near_zero)) start_behind_surface();

  while (remaining-- > 0) {
    double t;
    if (!search.find(begin, end, t)) return;
    if (report(t, 0) && ends_with_nearest) return;
    begin = t + gap;
    if (end - begin < a || (begin > sink.upper() && !search.memory)) return;
    search.sign = -search.sign;
  }
}

// What `trace` does for a ray, a stage at a time for all of them.
class Isosurface::BatchTrace {
 public:
  // Nearly: values need not be exact where the map says how wrong they are.
  BatchTrace(const Isosurface& shape, const RayPacket& rays, BatchHits& hits, FieldPacket& field,
             const CurvatureMap* map, bool approximate)
      : shape_(shape), s_(shape.surface_), rays_(rays), hits_(hits), field_(field) {
    packet_.accuracy = s_.accuracy, packet_.threshold = s_.threshold;
    packet_.map = map;
    if (approximate)
      packet_.doubt = 2 * map->error_bound() + std::fabs(s_.threshold) * 0x1p-50 + std::numeric_limits<double>::min();
  }

  // The rays of which it is not known what they meet.
  unsigned run() {
    unsigned active = pass_wall(enter());
    while (active != 0) {
      active = to_search(active & ~lost_);
      const unsigned found = find_intersections(field_, packet_, active);
      each_lane(active, [&](int k) { lost_ |= packet_.lost[k] != 0 ? 1u << k : 0; });
      active = go_on(found);
    }
    if (packet_.doubt > 0) return lost_;  // which met what is steeper
    double steepest = 0;
    each_lane(entered_, [&](int k) {
      if (packet_.steepest[k] > steepest * entry_.speed[k]) steepest = packet_.steepest[k] / entry_.speed[k];
    });
    raise(shape_.steepest_, steepest);
    return lost_;
  }

 private:
  // f - threshold at distances t, of the rays that are asked for; loses those for which it is not known what it is
  // like.
  Judged field(unsigned active_mask, const double* t, double* values) {
    kernels_.place(packet_, t, field_.points());
    const Judged judged =
        kernels_.judge(packet_, field_.evaluate(active_mask, packet_.doubt > 0), near_zero_, active_mask, values);
    lost_ |= judged.doubtful;
    return judged;
  }

  // The rays that meet the container.
  unsigned enter() {
    const double steepest = shape_.steepest_.load(std::memory_order_relaxed);
    const unsigned met =
        kernels_.enter(packet_, entry_, rays_, s_.container, shape_.to_object(), shape_.max_gradient_, steepest);
    const unsigned usual = kernels_.intervals(packet_, entry_).usual;
    entered_ = met & usual;
    hits_.alone |= met & ~usual;
    std::fill_n(remaining_, RayPacket::kCount, shape_.max_trace_);
    return entered_;
  }

  // Rays that begin at the surface begin behind it; hits on the container. The rays that are to be searched.
  unsigned pass_wall(unsigned active) {
    if (active == 0) return 0;
    const Judged begin = field(active, entry_.begin, entry_.at_begin), end = field(active, entry_.end, entry_.at_end);
    Intervals intervals = kernels_.intervals(packet_, entry_);
    const unsigned within = active & intervals.within;
    if (s_.open) active &= intervals.enough;
    if (const unsigned at_surface = active & within & (s_.open ? intervals.before & begin.close : begin.below);
        at_surface != 0) {
      each_lane(at_surface, [&](int k) { entry_.begin[k] = 5 * s_.accuracy; });
      field(at_surface, entry_.begin, entry_.at_begin);
      each_lane(at_surface, [&](int k) {
        if (entry_.at_begin[k] < 0) packet_.sign[k] = -1;
      });
      intervals = kernels_.intervals(packet_, entry_);
    }
    if (s_.open) return active;
    const unsigned at_wall = active & ~within & begin.negative;
    each_lane(at_wall, [&](int k) { --remaining_[k], packet_.sign[k] = -1; });
    active &= intervals.enough;
    unsigned over = 0;
    each_lane(active & at_wall, [&](int k) {
      over |= hits_.add(k, entry_.begin[k], static_cast<int>(entry_.enter_face[k])) ? 1u << k : 0;
    });
    each_lane(active & within & end.negative, [&](int k) {
      over |= hits_.add(k, entry_.end[k], static_cast<int>(entry_.leave_face[k])) && hits_.any ? 1u << k : 0;
    });
    return active & ~over;
  }

  unsigned to_search(unsigned active) {
    each_lane(active, [&](int k) {
      if (remaining_[k]-- <= 0) active &= ~(1u << k);
    });
    kernels_.set_up(packet_, entry_, active, s_.open);
    return active;
  }

  // The rays that found the surface where it is not wanted, and may find it again.
  unsigned go_on(unsigned found) {
    unsigned active = 0;
    each_lane(found, [&](int k) {
      const double t = packet_.hit[k];
      if (hits_.add(k, t, 0)) return;
      const double begin = entry_.begin[k] = t + 5 * s_.accuracy;
      if (entry_.end[k] - begin < s_.accuracy || begin > hits_.t_max[k]) return;
      packet_.sign[k] = -packet_.sign[k];
      active |= 1u << k;
    });
    if (active != 0) field(active, entry_.begin, entry_.at_begin);
    return active;
  }

  const Isosurface& shape_;
  const scene::Isosurface& s_;
  const RayPacket& rays_;
  BatchHits& hits_;
  FieldPacket& field_;
  const IsosurfaceKernels& kernels_ = isosurface_kernels();
  const double near_zero_ = 4 * shape_.max_gradient_ * s_.accuracy;
  SearchPacket packet_;
  unsigned entered_ = 0, lost_ = 0;
  EntryPacket entry_;
  int remaining_[RayPacket::kCount];
};

void Isosurface::trace_batch(const RayPacket& rays, BatchHits& hits, FieldPacket& field) const {
  constexpr int kMaxDoubts = 10000;  // then it is not worth while
  const CurvatureMap* const known = map();
  const bool approximate =
      known && std::isfinite(known->error_bound()) && doubts_.load(std::memory_order_relaxed) < kMaxDoubts;
  const unsigned lost = BatchTrace(*this, rays, hits, field, known, approximate).run();
  if (lost == 0) return;
  if (approximate) doubts_.fetch_add(std::popcount(lost), std::memory_order_relaxed);
  hits.forget(lost);
  BatchTrace(*this, {rays.rays, rays.first, lost}, hits, field, nullptr, false).run();
}

void Isosurface::remember_normals(unsigned found, Hit* hits) const {
  constexpr int kLanes = RayPacket::kCount;
  double points[3][kLanes] = {};
  unsigned lanes = 0;
  each_lane(found, [&](int k) {
    if (hits[k].part != 0) return;
    const Vec3 p = local(hits[k].point);
    if (on_shell(p)) return;
    lanes |= 1u << k;
    for (int axis = 0; axis < 3; ++axis) points[axis][k] = p[axis];
  });
  if (std::popcount(lanes) < kMin) return;
  alignas(64) double values[4 * kLanes], normals[3 * kLanes];
  evaluate_around(*in_batches_, points, surface_.accuracy, lanes, values);
  isosurface_kernels().normals(values, to_object(), normals);
  each_lane(lanes, [&](int k) {
    hits[k].u = normals_of_thread.add({number_,
                                       {hits[k].point.x, hits[k].point.y, hits[k].point.z},
                                       {normals[k], normals[kLanes + k], normals[2 * kLanes + k]}});
  });
}

}  // namespace

std::unique_ptr<Shape> compile_isosurface(const scene::Object& object) {
  return std::make_unique<Isosurface>(object, **object.as<std::shared_ptr<const scene::Isosurface>>());
}
Box3 isosurface_box(const scene::Isosurface& isosurface) { return container_box(isosurface.container); }

}  // namespace verisim::shapes
