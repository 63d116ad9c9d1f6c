// julia_fractal (spec 04 section 8): marching with distance estimates, then bisection. The hit depends on the whole
// sequence of steps, so it is followed exactly.
#include <cmath>
#include <utility>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/julia/julia_map.h"
#include "tracer/shapes/kept_point.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/shared_payload.h"

namespace verisim::shapes {

namespace {

using julia::kFine;
using julia::Kind;
using julia::Number;
using scene::JuliaFunction;

constexpr int kMaxIterations = 1 << 20;

// The iterates h0 .. hN of one point. Short ones live on the stack.
class Orbit {
 public:
  explicit Orbit(int length) {
    if (length > kShort) heap_ = std::make_unique<Step[]>(static_cast<std::size_t>(length)), at_ = heap_.get();
  }
  const Number& operator[](int i) const { return at_[i].h; }
  void set(int i, const Number& h) { copy(h, at_[i].h), at_[i].mapped = false; }
  // f(hi), if it was computed on the way to the next.
  void set_image(int i, const Number& image) { copy(image, at_[i].image), at_[i].mapped = true; }
  const Number* image(int i) const { return at_[i].mapped ? &at_[i].image : nullptr; }
  // Few ask for the last iterate of a point that stays: it comes from this one, hN-1 of the last such point.
  void leave_last(const Number& before) { before_last_ = before, last_is_left_ = true; }
  template <class Next>
  void complete(int last, Next&& next) {
    if (std::exchange(last_is_left_, false)) set(last, next(before_last_));
  }

 private:
  struct Step {
    Number h, image;
    bool mapped;
  };
  // Component by component: a wide load of what was just written in pieces waits for it.
  static void copy(const Number& from, Number& to) { to.x = from.x, to.y = from.y, to.z = from.z, to.w = from.w; }
  static constexpr int kShort = 64;
  alignas(Step) std::byte stack_[kShort * sizeof(Step)];  // not initialised: only what was computed is read
  std::unique_ptr<Step[]> heap_;
  Step* at_ = reinterpret_cast<Step*>(stack_);
  Number before_last_;
  bool last_is_left_ = false;
};

double bounding_radius(const scene::JuliaFractal& f) {
  if (f.hypercomplex) return 4;
  const auto& p = f.parameter;
  return std::min(2.0, 1 + std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]) + 1e-7);
}

julia::Field field_of(const scene::JuliaFractal& f) {
  julia::Field field;
  field.parameter = {f.parameter[0], f.parameter[1], f.parameter[2], f.parameter[3]};
  field.slice = {f.slice[0], f.slice[1], f.slice[2]}, field.slice_w = f.slice[3];
  field.slice_distance = f.slice_distance;
  field.iterations = std::clamp(f.max_iteration, 1, kMaxIterations);
  field.precision = 1 / std::max(f.precision, 1.0);
  const double radius = bounding_radius(f);
  field.escape = f.hypercomplex ? 16 : radius * radius + 1e-7;
  const JuliaFunction g = f.function;
  if (f.hypercomplex)
    field.kind = g == JuliaFunction::sqr || g == JuliaFunction::cube ? Kind::hypercomplex_square : Kind::other;
  else
    field.kind = g == JuliaFunction::cube ? Kind::quaternion_cube : Kind::quaternion_square;
  field.doubled = g == JuliaFunction::sqr;
  return field;
}

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
    // After an intersection POV-Ray's march goes on behind the coarse step, but counts distances from the intersection:
    // those of later hits, not their points, fall short.
    walk(orbit, r, begin, end, last, [&](double depth, const Vec3& point, double uncounted) {
      const Vec3 in_world = world(point);
      const KeptNormal kept = field_.kind == Kind::other ? keep_normal(orbit, point) : KeptNormal{};
      const double v = kept.axis != 0 ? kept.v : keep_local(point, in_world);
      sink.add((depth - uncounted) / r.scale, [&] { return in_world; }, kept.axis, kept.u, v);
      // Outside CSG the march ends with the first hit, even one too near to be seen: refracted rays often do not meet
      // the far side.
      return Sink::kNearest && !sink.clipped(in_world);
    });
  }

  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const final {
    if (!in_batches_ || std::popcount(rays.active) < kMin)
      return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    double t[julia::kLanes];
    julia::Points points;
    const unsigned found = within(t, t_min, t_max, batch_intersections(rays, t_max, t, points));
    each_lane(found, [&](int k) {
      const Vec3 in_world = world(points[k]);
      hits[k] = {t[k], in_world, this, 0, 0, keep_local(points[k], in_world)};
    });
    return found;
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const final {
    if (!in_batches_ || std::popcount(rays.active) < kMin) return Shape::occludes_packet(rays, entry, t_min, t_max);
    double t[julia::kLanes];
    julia::Points points;
    return within(t, t_min, t_max, batch_intersections(rays, t_max, t, points));
  }

  bool contains(const Vec3& p) const { return plain_inside(local(p)); }

  // Out of the fractal, inverted or not: whoever asks negates that of an inverted one (spec 04 8).
  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 n = outward_normal(hit);
    return inverted() ? -n : n;
  }

 private:
  Vec3 outward_normal(const Hit& hit) const {
    if (hit.part != 0) return KeptNormal{hit.part, hit.u, hit.v}.direction();
    Orbit orbit(field_.iterations + 1);
    const int escaped = iterate(orbit, start(found_point(hit, has_matrix() ? &matrix() : nullptr), !plain_));
    // Iterates beyond an early escape do not exist; the last one stands for them.
    const int last = escaped > 0 ? escaped - 1 : field_.iterations;
    if (escaped == 0) complete(orbit);
    const Vec3 n = f_.hypercomplex ? hypercomplex_normal(orbit, last) : quaternion_normal(orbit, last);
    return world_normal(n);
  }

  // What leads from a hit's point in the world to where it was found.
  double keep_local(const Vec3& point, const Vec3& in_world) const {
    return has_matrix() ? keep_point(point, matrix().inverse_point(in_world)) : 0;
  }

  // A unit vector by its two smaller components; axis: that of the largest and its sign, 1 to 3; 0: none is kept.
  struct KeptNormal {
    int axis = 0;
    double u = 0, v = 0;

    explicit KeptNormal() = default;
    KeptNormal(int a, double first, double second) : axis(a), u(first), v(second) {}
    explicit KeptNormal(const Vec3& n) {
      int k = 0;
      for (int i = 1; i < 3; ++i)
        if (std::fabs(n[i]) > std::fabs(n[k])) k = i;
      axis = n[k] < 0 ? -1 - k : 1 + k, u = n[(k + 1) % 3], v = n[(k + 2) % 3];
    }
    Vec3 direction() const {
      const int k = std::abs(axis) - 1;
      Vec3 n;
      n[k] = std::copysign(std::sqrt(std::max(0.0, 1 - u * u - v * v)), axis);
      n[(k + 1) % 3] = u, n[(k + 2) % 3] = v;
      return n;
    }
  };

  // The normal at a hit from which the iteration escapes: `orbit` still holds what the search left behind the escape.
  KeptNormal keep_normal(Orbit& orbit, const Vec3& point) const {
    if (iterate(orbit, start(point, !plain_)) == 0) return KeptNormal();
    complete(orbit);
    return KeptNormal(world_normal(hypercomplex_normal(orbit, field_.iterations)));
  }

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

  // The march from `begin` to `end`, with no intersection behind `last`. found(depth of an intersection, its point, by
  // how much later hits' distances fall short) says whether to stop. Where the march ends is counted short, too.
  template <class Found>
  void walk(Orbit& orbit, const LocalRay& r, double t, double end, double last, Found&& found) const {
    double estimate, uncounted = 0;
    Vec3 p = r.origin + t * r.direction;
    bool in = march(orbit, p, r.direction, estimate);
    if (in) {
      t += 2 * kFine, p += 2 * kFine * r.direction;
      if (t > end) return;
      in = march(orbit, p, r.direction, estimate);
    }
    const auto crossed = [&](const Reached& base, double step, bool now) {
      const Reached hit = bisect(orbit, base, r.direction, step, in);
      const double before = uncounted;
      in = now;
      uncounted += t - hit.depth;
      return found(hit.depth, hit.point, before);
    };
    while (t <= last) {
      if (estimate <= field_.precision && field_.kind != Kind::other) {
        // Where the smallest step is due it mostly is so for many steps: look ahead.
        double ahead[julia::kLanes], estimates[julia::kLanes], at = t;
        julia::Points points;
        Vec3 next_point = p;
        for (int k = 0; k < julia::kLanes; ++k) {
          ahead[k] = at += field_.precision;
          points.set(k, next_point += field_.precision * r.direction);
        }
        if (!(ahead[0] - uncounted <= end)) return;
        const unsigned inside = julia::kernels().march(field_, points, r.direction, estimates);
        for (int k = 0; k < julia::kLanes; ++k) {
          if (!(ahead[k] - uncounted <= end)) return;
          const Reached base{t, p};
          t = ahead[k], p = points[k], estimate = estimates[k];
          const bool now = inside >> k & 1;
          if (now != in && crossed(base, field_.precision, now)) return;
          if (estimate > field_.precision) break;
        }
        continue;
      }
      const double step = std::max(estimate, field_.precision);
      const Reached base{t, p};
      t += step, p += step * r.direction;
      if (!(t - uncounted <= end)) return;
      const bool now = march(orbit, p, r.direction, estimate);
      if (now != in && crossed(base, step, now)) return;
    }
  }

  // World distances of the first intersections of rays; the lanes that have one, unless it lies behind t_max.
  unsigned batch_intersections(const RayPacket& rays, const double* t_max, double* t, julia::Points& points) const {
    LocalPacket local_rays;
    packet_kernels().local(has_matrix() ? &matrix() : nullptr, rays, local_rays);
    julia::RaysInGrid within;
    const unsigned entered = julia::kernels().enter(map_->grid(), radius_, local_rays, rays.active, t_max, within);
    const unsigned crossed =
        julia::kernels().first_intersections(field_, within.rays, within.interval, entered, t, points);
    each_lane(crossed, [&](int k) { t[k] /= local_rays.scale[k]; });
    return crossed;
  }
  static unsigned within(const double* t, double t_min, const double* t_max, unsigned lanes) {
    unsigned result = 0;
    each_lane(lanes, [&](int k) { result |= t[k] >= t_min && t[k] < t_max[k] ? 1u << k : 0; });
    return result;
  }

  // Where the march is: the point is carried along, step by step, and its bits are not those of the distance.
  struct Reached {
    double depth;
    Vec3 point;
    Reached onward(double by, const Vec3& direction) const { return {depth + by, point + by * direction}; }
  };

  using MapPtr = std::shared_ptr<const julia::Map>;

  JuliaFractal(const scene::Object& description, const scene::JuliaFractal& f, MapPtr map)
      : Primitive(description, {map ? map->grid().box : julia_fractal_box(f), true, false}),
        f_(f),
        field_(field_of(f)),
        radius_(bounding_radius(f)),
        map_(std::move(map)) {
    in_batches_ = field_.kind != Kind::other && description.clipped_by.empty() && description.bounded_by.empty();
    plain_ = f.function == JuliaFunction::sqr || f.function == JuliaFunction::cube ||
             f.function == JuliaFunction::reciprocal;
  }
  static MapPtr map_of(const std::shared_ptr<const scene::JuliaFractal>& fractal) {
    const julia::Field field = field_of(*fractal);
    if (field.kind == Kind::other) return nullptr;
    return shared_payload<julia::Map>(fractal, [&] { return std::make_shared<julia::Map>(field); });
  }

  // The point in four dimensions. With `quirk` z is replaced by y before w is computed, as POV-Ray's plain inside test
  // does for most functions.
  Number start(const Vec3& p, bool quirk) const {
    const double z = quirk ? p.y : p.z;
    return {p.x, p.y, z,
            (f_.slice_distance - field_.slice.x * p.x - field_.slice.y * p.y - field_.slice.z * z) / field_.slice_w};
  }
  template <Kind K>
  static double norm2(const Number& h) {
    return K == Kind::other ? h.norm2_from_left() : h.norm2();
  }
  template <Kind K>
  Number next(const Number& h) const {
    if constexpr (K == Kind::quaternion_square)
      return julia::quaternion_square(h) + field_.parameter;
    else if constexpr (K == Kind::quaternion_cube)
      return julia::quaternion_cube(h) + field_.parameter;
    else if constexpr (K == Kind::hypercomplex_square)
      return product(h, h) + field_.parameter;
    else
      return julia::apply(f_.function, f_.exponent, h) + field_.parameter;
  }
  // Calls work with the kind of this fractal as a constant.
  template <class F>
  auto with_kind(F&& work) const {
    switch (field_.kind) {
      case Kind::quaternion_square:
        return work.template operator()<Kind::quaternion_square>();
      case Kind::quaternion_cube:
        return work.template operator()<Kind::quaternion_cube>();
      case Kind::hypercomplex_square:
        return work.template operator()<Kind::hypercomplex_square>();
      default:
        return work.template operator()<Kind::other>();
    }
  }
  // Fills the orbit but for the last iterate; the step i >= 1 at which it escaped, or 0.
  int iterate(Orbit& orbit, const Number& h0) const {
    return with_kind([&]<Kind K>() {
      Number h{h0.x, h0.y, h0.z, h0.w};
      orbit.set(0, h);
      for (int i = 1;; ++i) {
        if (norm2<K>(h) > field_.escape) return i;
        if (i == field_.iterations) break;
        if constexpr (K == Kind::other) {
          const Number image = julia::apply(f_.function, f_.exponent, h);
          orbit.set_image(i - 1, image);
          h = image + field_.parameter;
        } else {
          h = next<K>(h);
        }
        orbit.set(i, h);
      }
      orbit.leave_last(h);
      return 0;
    });
  }
  void complete(Orbit& orbit) const {
    with_kind([&]<Kind K>() {
      orbit.complete(field_.iterations, [&](const Number& h) { return next<K>(h); });
      return 0;
    });
  }
  bool plain_inside(const Vec3& p) const {
    return with_kind([&]<Kind K>() {
      Number h = start(p, !plain_);
      for (int i = 1;; ++i) {
        if (norm2<K>(h) > field_.escape) return false;
        if (i == field_.iterations) return true;
        h = next<K>(h);
      }
    });
  }

  // The intersection reported for a change of state between base and base + step; `in` is the state at base.
  Reached bisect(Orbit& orbit, const Reached& base, const Vec3& direction, double step, bool in) const {
    Reached low = base;
    double width = step;
    if (field_.kind == Kind::other) {
      while (width > kFine) {
        width /= 2;
        const Reached middle = low.onward(width, direction);
        if ((iterate(orbit, start(middle.point, !plain_)) == 0) == in) low = middle;
      }
      return in ? low : low.onward(width, direction);
    }
    while (width > kFine) {
      const unsigned inside = julia::kernels().halvings(field_, low.point, direction, width);
      for (unsigned n = 0; n < 15 && width > kFine;) {
        width /= 2;
        const bool same = (inside >> n & 1) == static_cast<unsigned>(in);
        if (same) low = low.onward(width, direction);
        n = 2 * n + (same ? 2 : 1);
      }
    }
    return in ? low : low.onward(width, direction);
  }

  // Inside at the point, and how far the ray may go from there.
  bool march(Orbit& orbit, const Vec3& point, const Vec3& direction, double& estimate) const {
    const Number h0 = start(point, false);
    if (field_.kind == Kind::quaternion_square) return march_quaternion<Kind::quaternion_square>(h0, estimate);
    if (field_.kind == Kind::quaternion_cube) return march_quaternion<Kind::quaternion_cube>(h0, estimate);
    const int escaped = iterate(orbit, h0);
    estimate = field_.precision;
    if (escaped == 0) return true;
    const Number& h = orbit[escaped - 1];
    const double q = field_.kind == Kind::other ? h.norm2_from_left() : h.norm2();
    const double slope = dot(hypercomplex_normal(orbit, escaped - 1), direction);
    if (slope < -1e-8) {
      const double decrease = -2 * slope;
      if (field_.precision * decrease < q && q < 30 * field_.precision * decrease) estimate = q / decrease;
    }
    return false;
  }

  template <Kind K>
  bool march_quaternion(const Number& h0, double& estimate) const {
    Number h = h0;
    double product2 = 1, power = 1;
    for (int i = 1; i <= field_.iterations; ++i) {
      const double q = h.norm2();
      product2 *= q;
      power *= K == Kind::quaternion_cube ? 1.0 / 3 : 1.0 / 2;
      if (q > field_.escape) {
        // ln q <= q - 1: most of the smallest steps need neither logarithm nor the product itself, for whose last bits
        // that of the lengths does not stand.
        estimate = power * std::sqrt(q / product2) * (q - 1) > field_.precision
                       ? power * std::sqrt(q / product_norm2<K>(h0, i)) * std::log(q)
                       : field_.precision;
        return false;
      }
      if (i < field_.iterations) h = next<K>(h);
    }
    estimate = field_.precision;
    return true;
  }
  // |h(count-1) ... h1 h0|^2
  template <Kind K>
  double product_norm2(Number h, int count) const {
    Number m = h;
    for (int i = 1; i < count; ++i) {
      h = next<K>(h);
      m = julia::quaternion_product(h, m);
    }
    return m.norm2_from_left();
  }

  // Gradient of |hM|^2 / 2 by x, y, z with w constant, constant factors dropped.
  Vec3 quaternion_normal(const Orbit& orbit, int last) const {
    Number dx{1, 0, 0, 0}, dy{0, 1, 0, 0}, dz{0, 0, 1, 0};
    const bool cube = f_.function == JuliaFunction::cube;
    for (int i = 0; i < last; ++i) {
      const Number& h = orbit[i];
      for (Number* d : {&dx, &dy, &dz}) {
        if (cube) {
          const double inner = h.y * d->y + h.z * d->z + h.w * d->w;
          const double q = h.y * h.y + h.z * h.z + h.w * h.w, x2 = h.x * h.x, t = 3 * x2 - q,
                       dt = 6 * h.x * d->x - 2 * inner;
          *d = {3 * (x2 - q) * d->x - 6 * h.x * inner, dt * h.y + t * d->y, dt * h.z + t * d->z, dt * h.w + t * d->w};
        } else {
          *d = {h.x * d->x - h.y * d->y - h.z * d->z - h.w * d->w, h.x * d->y + h.y * d->x, h.x * d->z + h.z * d->x,
                h.x * d->w + h.w * d->x};
        }
      }
    }
    const Number& h = orbit[last];
    const auto along = [&](const Number& d) { return h.x * d.x + h.y * d.y + h.z * d.z + h.w * d.w; };
    return {along(dx), along(dy), along(dz)};
  }

  Vec3 hypercomplex_normal(const Orbit& orbit, int last) const {
    Number m = orbit[0], n = orbit[last];
    if (field_.kind == Kind::hypercomplex_square) {
      for (int j = 1; j < last; ++j) m = product(orbit[j], m);
    } else {
      m = other_product(orbit, last);
    }
    if (f_.function == JuliaFunction::sqr) {
      const double scale = std::ldexp(1.0, std::max(last, 1));
      n = {n.x * scale, n.y * scale, n.z * scale, n.w * scale};
    }
    return {m.x * n.x + m.y * n.y + m.z * n.z + m.w * n.w, -m.y * n.x + m.x * n.y - m.w * n.z + m.z * n.w,
            -m.z * n.x - m.w * n.y + m.x * n.z + m.y * n.w};
  }
  Number other_product(const Orbit& orbit, int last) const {
    Number m = orbit[0];
    for (int j = 1; j < last; ++j) {
      switch (f_.function) {
        case JuliaFunction::reciprocal: {
          const Number r = julia::reciprocal(orbit[j]), r2 = product(r, r);
          m = product(m, Number{-r2.x, -r2.y, -r2.z, -r2.w});
          break;
        }
        default: {
          const Number* const image = orbit.image(j);
          m = product(image ? *image : julia::apply(f_.function, f_.exponent, orbit[j]), m);
        }
      }
    }
    return m;
  }

  scene::JuliaFractal f_;
  julia::Field field_;
  double radius_;
  std::shared_ptr<const julia::Map> map_;  // null: none for this function
  bool in_batches_;                        // rays may march in step: the first intersection of each decides
  bool plain_ = true;                      // without the quirk of `start`
};

}  // namespace

std::unique_ptr<Shape> compile_julia_fractal(const scene::Object& object) {
  return std::make_unique<JuliaFractal>(object, *object.as<std::shared_ptr<const scene::JuliaFractal>>());
}
Box3 julia_fractal_box(const scene::JuliaFractal& fractal) {
  const double r = bounding_radius(fractal);
  return Box3(Vec3(-r), Vec3(r));
}

}  // namespace verisim::shapes
