// julia_fractal (spec 04 section 8): rays one by one and in step, normals and insides.
#include <cmath>
#include <cstdint>
#include <utility>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/julia/julia_march.h"
#include "tracer/shapes/kept_point.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/shared_payload.h"

namespace verisim::shapes {

namespace {

using julia::kFine;
using julia::Kind;
using julia::Orbit;

class JuliaFractal final : public Primitive<JuliaFractal> {
 public:
  JuliaFractal(const scene::Object& description, const std::shared_ptr<const scene::JuliaFractal>& fractal)
      : JuliaFractal(description, *fractal, map_of(fractal)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay r = local(ray);
    double begin, end, last;
    if (!enters(r, begin, end, last)) return;
    Orbit orbit(field_.iterations + 1);
    julia::March(iteration_)
        .walk(orbit, {r.origin, r.direction}, begin, end, last, [&](double depth, const Vec3& point) {
          const Vec3 in_world = world(point);
          const double distance = depth / r.scale;
          // Too near to be seen: by rays of subsurface light neither, which see what is nearer of other shapes.
          if (distance < kNearest) return !in_csg_ && !sink.clipped(in_world);
          const KeptNormal kept = is_power(field_.kind) ? KeptNormal{} : keep_normal(orbit, point);
          const double v = kept.axis != 0 ? kept.v : keep_local(point, in_world);
          const bool taken = sink.add(
              distance, [&] { return in_world; }, kept.axis, kept.u, v);
          // Outside CSG the march ends with the first hit, even one too near: refracted rays often do not meet the far
          // side. So it does in a light that looks like it, be that in CSG.
          return in_csg_ ? Sink::kNearest && (taken || distance >= sink.upper()) : !sink.clipped(in_world);
        });
  }

  void join_csg() override { in_csg_ = true; }
  // Hits behind the first are said to be nearer than they are (spec 04 8).
  bool may_stray() const override { return in_csg_; }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const final {
    if (!in_batches_ || std::popcount(rays.active) < kMin)
      return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    double t[julia::kLanes];
    julia::Points points;
    julia::NormalsOfSearch normals;
    const unsigned crossed = batch_intersections(rays, t_max, t, points, is_power(field_.kind) ? nullptr : &normals);
    unsigned found = within(t, t_min, t_max, crossed);
    each_lane(found, [&](int k) {
      const Vec3 in_world = world(points[k]);
      const KeptNormal kept = normals.lanes >> k & 1 ? KeptNormal(world_normal(normals.normals[k])) : KeptNormal{};
      hits[k] = {t[k], in_world, this, kept.axis, kept.u, kept.axis != 0 ? kept.v : keep_local(points[k], in_world)};
    });
    each_lane(march_on(t, t_min, crossed),
              [&](int k) { found |= intersect(rays.at(k), kind, t_min, t_max[k], hits[k]) ? 1u << k : 0; });
    return found;
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const final {
    if (!in_batches_ || std::popcount(rays.active) < kMin) return Shape::occludes_packet(rays, entry, t_min, t_max);
    double t[julia::kLanes];
    julia::Points points;
    const unsigned crossed = batch_intersections(rays, t_max, t, points, nullptr);
    unsigned found = within(t, t_min, t_max, crossed);
    each_lane(march_on(t, t_min, crossed),
              [&](int k) { found |= occludes(rays.at(k), t_min, t_max[k]) ? 1u << k : 0; });
    return found;
  }

  bool contains(const Vec3& p) const { return iteration_.inside(local(p)); }

  // Out of the fractal, inverted or not: whoever asks negates that of an inverted one (spec 04 8).
  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 n = outward_normal(hit);
    return inverted() ? -n : n;
  }

 private:
  Vec3 outward_normal(const Hit& hit) const {
    if (hit.part != 0) return KeptNormal{hit.part, hit.u, hit.v}.direction();
    Orbit orbit(field_.iterations + 1);
    const int escaped =
        iteration_.iterate(orbit, iteration_.start_of_inside(found_point(hit, has_matrix() ? &matrix() : nullptr)));
    // Iterates beyond an early escape do not exist; the last one stands for them.
    const int last = escaped > 0 ? escaped - 1 : field_.iterations;
    if (escaped == 0) iteration_.complete(orbit);
    return world_normal(iteration_.normal(orbit, last));
  }

  // What leads from a hit's point in the world to where it was found.
  double keep_local(const Vec3& point, const Vec3& in_world) const {
    return has_matrix() ? keep_point(point, matrix().inverse_point(in_world)) : 0;
  }

  // A unit vector by its two smaller components. `axis`: that of the largest and its sign, 1 to 3, and in the bits
  // above how far the largest is from what the others make of it, in last places; 0: none is kept.
  struct KeptNormal {
    int axis = 0;
    double u = 0, v = 0;

    explicit KeptNormal() = default;
    KeptNormal(int a, double first, double second) : axis(a), u(first), v(second) {}
    explicit KeptNormal(const Vec3& n) {
      int k = 0;
      for (int i = 1; i < 3; ++i)
        if (std::fabs(n[i]) > std::fabs(n[k])) k = i;
      u = n[(k + 1) % 3], v = n[(k + 2) % 3];
      const auto steps = static_cast<std::int64_t>(static_cast<std::uint64_t>(kept_point::rank(std::fabs(n[k]))) -
                                                   static_cast<std::uint64_t>(kept_point::rank(largest())));
      axis = static_cast<int>(steps >= -kMaxSteps && steps <= kMaxSteps ? steps + kMaxSteps : kMaxSteps) << 2 | (1 + k);
      if (n[k] < 0) axis = -axis;
    }
    Vec3 direction() const {
      const int k = (std::abs(axis) & 3) - 1, steps = (std::abs(axis) >> 2) - kMaxSteps;
      Vec3 n;
      n[k] = std::copysign(kept_point::of_rank(kept_point::rank(largest()) + steps), axis);
      n[(k + 1) % 3] = u, n[(k + 2) % 3] = v;
      return n;
    }

   private:
    double largest() const { return std::sqrt(std::max(0.0, 1 - u * u - v * v)); }

    static constexpr int kMaxSteps = 1 << 20;
  };

  // The normal at a hit from which the iteration escapes: `orbit` still holds what the search left behind the escape.
  KeptNormal keep_normal(Orbit& orbit, const Vec3& point) const {
    if (iteration_.iterate(orbit, iteration_.start_of_inside(point)) == 0) return KeptNormal();
    iteration_.complete(orbit);
    return KeptNormal(world_normal(iteration_.hypercomplex_normal(orbit, field_.iterations)));
  }

  static constexpr double kNearest = 1e-4;
  static constexpr int kMin = 3;  // rays that march in step; fewer look ahead instead

  // Where the ray is in the bounding sphere, and where behind it stays outside; false: nothing can be hit. In just
  // these operations: whether the first point escapes at once is a matter of the last bit, and the whole sequence of
  // steps hangs on it.
  bool enters(const LocalRay& r, double& begin, double& end, double& last) const {
    const double closest = -dot(r.origin, r.direction),
                 half2 = radius_ * radius_ - dot(r.origin, r.origin) + closest * closest;
    if (!(half2 > kEpsilon) || (closest < kEpsilon && dot(r.origin, r.origin) >= radius_ * radius_)) return false;
    const double half = std::sqrt(half2);
    end = closest + half;
    if (!(end >= kFine)) return false;
    begin = std::max(closest - half, kFine);
    last = map_ ? map_->last(r.origin, r.direction, begin, end) : end;
    return !(last < 0);
  }

  // World distances of the first intersections of rays; the lanes that have one, unless it lies behind t_max.
  unsigned batch_intersections(const RayPacket& rays, const double* t_max, double* t, julia::Points& points,
                               julia::NormalsOfSearch* normals) const {
    LocalPacket local_rays;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, local_rays);
    julia::RaysInGrid within;
    const unsigned entered =
        julia::kernels().enter(map_ ? &map_->grid() : nullptr, radius_, local_rays, rays.active, t_max, within);
    const unsigned crossed =
        julia::kernels().first_intersections(field_, within.rays, within.interval, entered, t, points, normals);
    each_lane(crossed, [&](int k) { t[k] /= local_rays.scale[k]; });
    return crossed;
  }
  static unsigned within(const double* t, double t_min, const double* t_max, unsigned lanes) {
    unsigned result = 0;
    each_lane(lanes, [&](int k) { result |= t[k] >= t_min && t[k] < t_max[k] ? 1u << k : 0; });
    return result;
  }

  // The lanes whose march goes on behind a hit that is too near.
  unsigned march_on(const double* t, double t_min, unsigned lanes) const {
    unsigned result = 0;
    if (in_csg_) each_lane(lanes, [&](int k) { result |= t[k] < t_min ? 1u << k : 0; });
    return result;
  }

  using MapPtr = std::shared_ptr<const julia::Map>;

  JuliaFractal(const scene::Object& description, const scene::JuliaFractal& f, MapPtr map)
      // What functions without a map ask of their inside is not bounded along z (spec 04 8).
      : Primitive(description, {map ? map->grid().box : julia_fractal_box(f), map != nullptr, false}),
        iteration_(f),
        radius_(julia::bounding_radius(f)),
        map_(std::move(map)) {
    in_batches_ = (is_power(field_.kind) || field_.iterations <= julia::Kernels::kMostKept) &&
                  description.clipped_by.empty() && description.bounded_by.empty();
  }
  static MapPtr map_of(const std::shared_ptr<const scene::JuliaFractal>& fractal) {
    const julia::Field field = julia::field_of(*fractal);
    if (!is_power(field.kind)) return nullptr;
    return shared_payload<julia::Map>(fractal, [&] { return std::make_shared<julia::Map>(field); });
  }

  julia::Iteration iteration_;
  const julia::Field& field_ = iteration_.field();
  double radius_;
  std::shared_ptr<const julia::Map> map_;  // null: none for this function
  bool in_csg_ = false;
  bool in_batches_;  // rays may march in step: the first intersection of each decides
};

}  // namespace

std::unique_ptr<Shape> compile_julia_fractal(const scene::Object& object) {
  return std::make_unique<JuliaFractal>(object, *object.as<std::shared_ptr<const scene::JuliaFractal>>());
}
Box3 julia_fractal_box(const scene::JuliaFractal& fractal) {
  const double r = julia::bounding_radius(fractal);
  return Box3(Vec3(-r), Vec3(r));
}

}  // namespace verisim::shapes
