// julia_fractal (spec 04 section 8): marching with distance estimates, then bisection. The hit depends on the whole sequence of steps, so it is followed
// exactly.
#include <cmath>

#include "tracer/shapes/container.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/julia_algebra.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

namespace {

using julia::Number;
using scene::JuliaFunction;

constexpr double kFine = 1e-7;  // tolerance of depths
constexpr int kMaxIterations = 1 << 20;

// The iterates h0 .. hN of one point. Short ones live on the stack.
class Orbit {
 public:
  explicit Orbit(int length) {
    if (length > kShort) heap_ = std::make_unique<Number[]>(static_cast<std::size_t>(length)), at_ = heap_.get();
  }
  Number& operator[](int i) { return at_[i]; }
  const Number& operator[](int i) const { return at_[i]; }

 private:
  static constexpr int kShort = 64;
  alignas(Number) std::byte stack_[kShort * sizeof(Number)];  // not initialised: only what was computed is read
  std::unique_ptr<Number[]> heap_;
  Number* at_ = reinterpret_cast<Number*>(stack_);
};

double bounding_radius(const scene::JuliaFractal& f) {
  if (f.hypercomplex) return 4;
  const auto& p = f.parameter;
  return std::min(2.0, 1 + std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]) + 1e-7);
}

class JuliaFractal final : public Primitive<JuliaFractal> {
 public:
  JuliaFractal(const scene::Object& description, const scene::JuliaFractal& f) : Primitive(description, {julia_fractal_box(f), true}), f_(f) {
    parameter_ = {f.parameter[0], f.parameter[1], f.parameter[2], f.parameter[3]};
    const auto& s = f.slice;
    const double norm = std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + s[3] * s[3]);
    for (int k = 0; k < 3; ++k) slice_[k] = s[static_cast<std::size_t>(k)] / norm;
    slice_w_ = s[3] / norm;
    iterations_ = std::clamp(f.max_iteration, 1, kMaxIterations);
    precision_ = 1 / std::max(f.precision, 1.0);
    radius_ = bounding_radius(f);
    escape_ = f.hypercomplex ? 16 : radius_ * radius_ + 1e-7;
    const JuliaFunction g = f.function;
    if (f.hypercomplex) kind_ = g == JuliaFunction::sqr || g == JuliaFunction::cube ? Kind::hypercomplex_square : Kind::other;
    else kind_ = g == JuliaFunction::cube ? Kind::quaternion_cube : Kind::quaternion_square;
    plain_ = g == JuliaFunction::sqr || g == JuliaFunction::cube || g == JuliaFunction::reciprocal;
  }

  template <class Sink>
  void crossings(const Ray& ray, Sink& sink) const {
    const LocalRay r = local(ray);
    const scene::Contained ball{true, Vec3(0), Vec3(0), {0, 0, 0}, radius_};
    ContainerSpan span;
    if (!intersect_container(ball, r.origin, r.direction, span) || !(span.leave >= kFine)) return;
    const double end = span.leave;
    double t = std::max(span.enter, kFine), estimate;
    Orbit orbit(iterations_ + 1);
    bool in = march(orbit, r, t, estimate);
    if (in) {
      t += 2 * kFine;
      if (t > end) return;
      in = march(orbit, r, t, estimate);
    }
    for (;;) {
      const double step = std::max(estimate, precision_), base = t;
      t += step;
      if (!(t <= end)) return;
      const bool now = march(orbit, r, t, estimate);
      if (now == in) continue;
      // The plain test decides between the two ends.
      double low = base, width = step;
      while (width > kFine) {
        width /= 2;
        if (plain_inside(r.origin + (low + width) * r.direction) == in) low += width;
      }
      const double depth = in ? low : low + width, world_t = depth / r.scale;
      in = now;
      sink.add(world_t, [&] { return ray.at(world_t); });
      // Outside CSG the march ends with the first hit, even one too near to be seen: refracted rays often do not meet the far side.
      if (Sink::kNearest && !sink.clipped(ray.at(world_t))) return;
    }
  }

  bool contains(const Vec3& p) const { return plain_inside(local(p)); }

  Vec3 raw_normal(const Hit& hit) const {
    Orbit orbit(iterations_ + 1);
    const int escaped = iterate(orbit, start(local(hit.point), !plain_));
    // Iterates beyond an early escape do not exist; the last one stands for them.
    const int last = escaped > 0 ? escaped - 1 : iterations_;
    const Vec3 n = f_.hypercomplex ? hypercomplex_normal(orbit, last) : quaternion_normal(orbit, last);
    return world_normal(n);
  }

 private:
  // The point in four dimensions. With `quirk` z is replaced by y before w is computed, as POV-Ray's plain inside test does for most functions.
  Number start(const Vec3& p, bool quirk) const {
    const double z = quirk ? p.y : p.z;
    return {p.x, p.y, z, (f_.slice_distance - slice_.x * p.x - slice_.y * p.y - slice_.z * z) / slice_w_};
  }
  enum class Kind : unsigned char { quaternion_square, quaternion_cube, hypercomplex_square, other };
  template <Kind K>
  Number next(const Number& h) const {
    if constexpr (K == Kind::quaternion_square) return julia::quaternion_square(h) + parameter_;
    else if constexpr (K == Kind::quaternion_cube) return julia::quaternion_cube(h) + parameter_;
    else if constexpr (K == Kind::hypercomplex_square) return product(h, h) + parameter_;
    else return julia::apply(f_.function, f_.exponent, h) + parameter_;
  }
  // Calls work with the kind of this fractal as a constant.
  template <class F>
  auto with_kind(F&& work) const {
    switch (kind_) {
      case Kind::quaternion_square: return work.template operator()<Kind::quaternion_square>();
      case Kind::quaternion_cube: return work.template operator()<Kind::quaternion_cube>();
      case Kind::hypercomplex_square: return work.template operator()<Kind::hypercomplex_square>();
      default: return work.template operator()<Kind::other>();
    }
  }
  // Fills the orbit; the step i >= 1 at which it escaped, or 0.
  int iterate(Orbit& orbit, const Number& h0) const {
    return with_kind([&]<Kind K>() {
      Number h = h0;
      orbit[0] = h;
      for (int i = 1; i <= iterations_; ++i) {
        if (h.norm2() > escape_) return i;
        orbit[i] = h = next<K>(h);
      }
      return 0;
    });
  }
  bool plain_inside(const Vec3& p) const {
    return with_kind([&]<Kind K>() {
      Number h = start(p, !plain_);
      for (int i = 1; i <= iterations_; ++i) {
        if (h.norm2() > escape_) return false;
        h = next<K>(h);
      }
      return true;
    });
  }

  // Inside at depth t, and how far the ray may go from there.
  bool march(Orbit& orbit, const LocalRay& ray, double t, double& estimate) const {
    const int escaped = iterate(orbit, start(ray.origin + t * ray.direction, false));
    estimate = precision_;
    if (escaped == 0) return true;
    const double q = orbit[escaped - 1].norm2();
    if (!f_.hypercomplex) {
      double product2 = 1;
      for (int i = 0; i < escaped; ++i) product2 *= orbit[i].norm2();
      const double k = f_.function == JuliaFunction::cube ? 1.0 / 3 : 1.0 / 2;
      double power = 1;
      for (int i = 0; i < escaped; ++i) power *= k;
      estimate = power * std::sqrt(q / product2) * std::log(q);
      return false;
    }
    const double slope = dot(hypercomplex_normal(orbit, escaped - 1), ray.direction);
    if (slope < -1e-8) {
      const double decrease = -2 * slope;
      if (precision_ * decrease < q && q < 30 * precision_ * decrease) estimate = q / decrease;
    }
    return false;
  }

  // Gradient of |hM|^2 / 2 by x, y, z with w constant, constant factors dropped.
  Vec3 quaternion_normal(const Orbit& orbit, int last) const {
    Number dx{1, 0, 0, 0}, dy{0, 1, 0, 0}, dz{0, 0, 1, 0};
    const bool cube = f_.function == JuliaFunction::cube;
    for (int i = 0; i < last; ++i) {
      const Number& h = orbit[i];
      for (Number* d : {&dx, &dy, &dz}) {
        const double inner = h.y * d->y + h.z * d->z + h.w * d->w;
        if (cube) {
          const double q = h.y * h.y + h.z * h.z + h.w * h.w, x2 = h.x * h.x, t = 3 * x2 - q, dt = 6 * h.x * d->x - 2 * inner;
          *d = {3 * (x2 - q) * d->x - 6 * h.x * inner, dt * h.y + t * d->y, dt * h.z + t * d->z, dt * h.w + t * d->w};
        } else {
          *d = {h.x * d->x - inner, d->x * h.y + h.x * d->y, d->x * h.z + h.x * d->z, d->x * h.w + h.x * d->w};
        }
      }
    }
    const Number& h = orbit[last];
    const auto along = [&](const Number& d) { return h.x * d.x + h.y * d.y + h.z * d.z + h.w * d.w; };
    return {along(dx), along(dy), along(dz)};
  }

  Vec3 hypercomplex_normal(const Orbit& orbit, int last) const {
    Number m = orbit[0], n = orbit[last];
    if (kind_ == Kind::hypercomplex_square) {
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
        default: m = product(julia::apply(f_.function, f_.exponent, orbit[j]), m);
      }
    }
    return m;
  }

  scene::JuliaFractal f_;
  Number parameter_;
  Vec3 slice_;
  double slice_w_ = 1, precision_ = 0.05, radius_ = 2, escape_ = 4;
  int iterations_ = 20;
  Kind kind_ = Kind::quaternion_square;
  bool plain_ = true;  // without the quirk of `start`
};

}  // namespace

std::unique_ptr<Shape> compile_julia_fractal(const scene::Object& object) {
  return std::make_unique<JuliaFractal>(object, **object.as<std::shared_ptr<const scene::JuliaFractal>>());
}
Box3 julia_fractal_box(const scene::JuliaFractal& fractal) {
  const double r = bounding_radius(fractal);
  return Box3(Vec3(-r), Vec3(r));
}

}  // namespace verisim::shapes
