// Helpers of the shape tests: build functions, shoot rays, compare with probe values.
#pragma once

#include <cstring>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <random>

#include "tracer/functions/function.h"
#include "tracer/math/ray_batch.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes::test {

// A C++ callable of x, y, z (or u, v) as a scene function.
template <int Parameters = 3>
class Callable final : public Function {
 public:
  using F = std::function<double(const double*)>;
  explicit Callable(F f) : f_(std::move(f)) {}
  int parameters() const override { return Parameters; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> a, double* result) const override { *result = f_(a.data()); }

 private:
  F f_;
};
template <class F>
FunctionPtr xyz(F f) {
  return std::make_shared<Callable<3>>([f](const double* a) { return f(a[0], a[1], a[2]); });
}

template <class S>
scene::Object object(S shape) {
  scene::Object o;
  o.shape = std::make_shared<const S>(std::move(shape));
  return o;
}

inline scene::ObjectPtr box(const Vec3& low, const Vec3& high) {
  auto o = std::make_shared<scene::Object>();
  o->shape = scene::Box{low, high};
  scene::compute_bounds(*o);
  return o;
}

struct Traced {
  Vec3 point, normal;
  Hit hit;
};
// The way trace() works: the nearest hit at t >= 1e-4.
inline std::optional<Traced> trace(const Shape& s, const Vec3& o, const Vec3& d) {
  Hit hit;
  if (!s.intersect({o, normalize(d)}, RayKind::query, 1e-4, 1e20, hit)) return std::nullopt;
  return Traced{hit.point, hit.shape->normal(hit), hit};
}
inline std::optional<Traced> trace(const scene::Object& o, const Vec3& from, const Vec3& d) {
  return trace(*compile(o), from, d);
}

#define EXPECT_VEC_NEAR(A, B, TOLERANCE)      \
  do {                                        \
    const Vec3 a_ = (A), b_ = (B);            \
    EXPECT_NEAR(a_.x, b_.x, TOLERANCE) << #A; \
    EXPECT_NEAR(a_.y, b_.y, TOLERANCE) << #A; \
    EXPECT_NEAR(a_.z, b_.z, TOLERANCE) << #A; \
  } while (false)

}  // namespace verisim::shapes::test
