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

// Rays from outside, from within and along the surface, some of them not asked and some with a limit before the hit.
inline void expect_rows_as_single_rays(const Shape& shape, std::mt19937& random, int& found) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&](double size) { return size * Vec3(unit(random), unit(random), unit(random)); };
  RayBatch batch{};
  const int first = 8 * static_cast<int>(random() % 5);
  const double far = random() % 4 == 0 ? 1 : 5;
  for (int k = 0; k < RayPacket::kCount; ++k) {
    const Vec3 from = vector(far);
    batch.origin.set(first + k, from);
    batch.direction.set(first + k, normalize(vector(1.2) - from));
  }
  const RayPacket rays{batch, first, static_cast<unsigned>(random() % 4 == 0 ? random() & 255 : 255)};
  double t_max[RayPacket::kCount];
  for (double& t : t_max) t = random() % 3 == 0 ? 3 * (1 + unit(random)) : 1e7;
  Hit hits[RayPacket::kCount];
  const unsigned hit = shape.intersect_packet(rays, nullptr, RayKind::camera, 1e-4, t_max, hits),
                 blocked = shape.occludes_packet(rays, nullptr, 1e-4, t_max);
  for (int k = 0; k < RayPacket::kCount; ++k) {
    if (!(rays.active >> k & 1)) continue;
    Hit single;
    ASSERT_EQ(shape.intersect(rays.at(k), RayKind::camera, 1e-4, t_max[k], single), static_cast<bool>(hit >> k & 1));
    ASSERT_EQ(shape.occludes(rays.at(k), 1e-4, t_max[k]), static_cast<bool>(blocked >> k & 1));
    if (!(hit >> k & 1)) continue;
    ++found;
    ASSERT_EQ(hits[k].t, single.t);
    ASSERT_EQ(hits[k].point, single.point);
    ASSERT_EQ(hits[k].shape, single.shape);
    ASSERT_EQ(hits[k].part, single.part);
    const Vec3 in_batch = shape.normal(hits[k]), alone = shape.normal(single);
    ASSERT_EQ(std::memcmp(&in_batch, &alone, sizeof alone), 0);
  }
}

}  // namespace verisim::shapes::test
