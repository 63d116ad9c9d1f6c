// What a julia_fractal's iteration makes of one point (spec 04 section 8): whether it stays, and normals.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "tracer/scene/object.h"
#include "tracer/shapes/julia/julia_map.h"

namespace verisim::shapes::julia {

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

constexpr int kMaxIterations = 1 << 20;

inline double bounding_radius(const scene::JuliaFractal& f) {
  if (f.hypercomplex) return 4;
  const auto& p = f.parameter;
  return std::min(2.0, 1 + std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]) + 1e-7);
}

inline Field field_of(const scene::JuliaFractal& f) {
  Field field;
  field.function = f.function, field.exponent = f.exponent;
  field.parameter = {f.parameter[0], f.parameter[1], f.parameter[2], f.parameter[3]};
  field.slice = {f.slice[0], f.slice[1], f.slice[2]}, field.slice_w = f.slice[3];
  field.slice_distance = f.slice_distance;
  field.iterations = std::clamp(f.max_iteration, 1, kMaxIterations);
  field.precision = 1 / std::max(f.precision, 1.0);
  const double radius = bounding_radius(f);
  field.escape = f.hypercomplex ? 16 : radius * radius + 1e-7;
  const scene::JuliaFunction g = f.function;
  if (f.hypercomplex)
    field.kind = g == scene::JuliaFunction::sqr          ? Kind::hypercomplex_square
                 : g == scene::JuliaFunction::cube       ? Kind::hypercomplex_cube
                 : g == scene::JuliaFunction::reciprocal ? Kind::reciprocal
                                                         : Kind::function;
  else
    field.kind = g == scene::JuliaFunction::cube ? Kind::quaternion_cube : Kind::quaternion_square;
  return field;
}

class Iteration {
 public:
  explicit Iteration(const scene::JuliaFractal& f) : field_(field_of(f)) {}
  const Field& field() const { return field_; }

  // The point in four dimensions.
  Number start(const Vec3& p) const { return first_iterate<Number>(field_, p); }
  // The same as the plain inside test takes it: POV-Ray replaces z by y there before w is computed for functions.
  Number start_of_inside(const Vec3& p) const { return start(field_.kind == Kind::function ? Vec3(p.x, p.y, p.y) : p); }
  template <Kind K>
  Number next(const Number& h) const {
    return plus(image_of<K>(h), field_.parameter);
  }
  // Fills the orbit but for the last iterate; the step i >= 1 at which it escaped, or 0.
  int iterate(Orbit& orbit, const Number& h0) const {
    return with_kind(field_.kind, [&]<Kind K>() {
      Number h{h0.x, h0.y, h0.z, h0.w};
      orbit.set(0, h);
      for (int i = 1;; ++i) {
        if (norm2<K>(h) > field_.escape) return i;
        if (i == field_.iterations) break;
        if constexpr (K == Kind::function) {
          const Number image = image_of<K>(h);
          orbit.set_image(i - 1, image);
          h = plus(image, field_.parameter);
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
    with_kind(field_.kind, [&]<Kind K>() {
      orbit.complete(field_.iterations, [&](const Number& h) { return next<K>(h); });
      return 0;
    });
  }
  bool inside(const Vec3& p) const {
    return with_kind(field_.kind, [&]<Kind K>() {
      Number h = start_of_inside(p);
      for (int i = 1;; ++i) {
        if (norm2<K>(h) > field_.escape) return false;
        if (i == field_.iterations) return true;
        h = next<K>(h);
      }
    });
  }

  // Out of the set, of any length.
  Vec3 normal(const Orbit& orbit, int last) const {
    return is_quaternion(field_.kind) ? quaternion_normal(orbit, last) : hypercomplex_normal(orbit, last);
  }
  Vec3 hypercomplex_normal(const Orbit& orbit, int last) const {
    Number m = orbit[0], n = orbit[last];
    with_kind(field_.kind, [&]<Kind K>() {
      for (int j = 1; j < last; ++j) {
        if constexpr (is_power(K)) {
          m = product(orbit[j], m);
        } else {
          const Number* const known = orbit.image(j);
          m = with_iterate<K>(m, orbit[j], known ? *known : image_of<K>(orbit[j]));
        }
      }
    });
    if (field_.kind == Kind::hypercomplex_square) n = scaled(n, std::ldexp(1.0, std::max(last, 1)));
    return hypercomplex_gradient<Vec3>(m, n);
  }

 private:
  template <Kind K>
  Number image_of(const Number& h) const {
    if constexpr (K == Kind::function)
      return image_by_function(field_, h);
    else
      return image<K>(h);
  }

  // Gradient of |hM|^2 / 2 by x, y, z with w constant, constant factors dropped.
  Vec3 quaternion_normal(const Orbit& orbit, int last) const {
    Number dx{1, 0, 0, 0}, dy{0, 1, 0, 0}, dz{0, 0, 1, 0};
    const bool cube = field_.kind == Kind::quaternion_cube;
    for (int i = 0; i < last; ++i) {
      const Number& h = orbit[i];
      for (Number* d : {&dx, &dy, &dz}) {
        if (cube) {
          const double inner = h.y * d->y + h.z * d->z + h.w * d->w;
          const double q = h.y * h.y + h.z * h.z + h.w * h.w, x2 = h.x * h.x, t = 3 * x2 - q,
                       dt = 6 * h.x * d->x - 2 * inner;
          *d = {3 * ((x2 - q) * d->x - 2 * (h.x * inner)), dt * h.y + t * d->y, dt * h.z + t * d->z,
                dt * h.w + t * d->w};
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

  Field field_;
};

}  // namespace verisim::shapes::julia
