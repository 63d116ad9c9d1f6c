// Builders and questions for the tests of shapes: what the parser does to an object, and what SDL's trace() and
// inside() ask of it.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

#include "tracer/query.h"
#include "tracer/scene/bounds.h"
#include "tracer/scene/object.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes::testing {

using scene::Object;
using ObjectRef = std::shared_ptr<Object>;
using Steps = std::function<void(Object&)>;

// An object from its parameters; `modify` stands for the modifier list.
template <class T>
ObjectRef make(T shape, const Steps& modify = {}) {
  auto object = std::make_shared<Object>();
  object->shape = std::move(shape);
  scene::compute_bounds(*object);
  if (modify) modify(*object);
  scene::finish_modifiers(*object);
  return object;
}

template <class T>
ObjectRef make_shared_shape(T shape, const Steps& modify = {}) {
  return make(std::shared_ptr<const T>(std::make_shared<T>(std::move(shape))), modify);
}

inline ObjectRef csg(scene::CsgKind kind, const std::vector<ObjectRef>& children, const Steps& modify = {},
                     bool difference = false) {
  scene::Csg shape;
  shape.kind = kind;
  shape.difference = difference;
  for (const ObjectRef& child : children) shape.children.push_back(scene::copy(*child));
  return make(std::move(shape), modify);
}
inline ObjectRef make_union(const std::vector<ObjectRef>& c, const Steps& m = {}) {
  return csg(scene::CsgKind::union_, c, m);
}
inline ObjectRef make_merge(const std::vector<ObjectRef>& c, const Steps& m = {}) {
  return csg(scene::CsgKind::merge, c, m);
}
inline ObjectRef make_intersection(const std::vector<ObjectRef>& c, const Steps& m = {}) {
  return csg(scene::CsgKind::intersection, c, m);
}
inline ObjectRef make_difference(std::vector<ObjectRef> c, const Steps& m = {}) {
  for (std::size_t i = 1; i < c.size(); ++i) {
    c[i] = scene::copy(*c[i]);
    scene::invert(*c[i]);
  }
  return csg(scene::CsgKind::intersection, c, m, true);
}

inline std::vector<double> march(const ObjectRef& object, const Vec3& origin, const Vec3& direction) {
  const query::Target target(object);
  std::vector<double> distances;
  const Vec3 d = normalize(direction);
  Vec3 from = origin;
  while (distances.size() < 100) {
    const auto hit = target.trace(from, d);
    if (!hit) break;
    distances.push_back(dot(hit->point - origin, d));
    from = hit->point;
  }
  return distances;
}

inline void expect_near(const Vec3& actual, const Vec3& expected, double tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

inline void expect_trace(const ObjectRef& object, const Vec3& origin, const Vec3& direction, const Vec3& point,
                         const Vec3& normal, double tolerance = 2e-12) {
  const auto hit = query::Target(object).trace(origin, direction);
  ASSERT_TRUE(hit.has_value());
  expect_near(hit->point, point, tolerance);
  expect_near(hit->normal, normal, tolerance);
}

inline void expect_march(const ObjectRef& object, const Vec3& origin, const Vec3& direction,
                         const std::vector<double>& expected, double tolerance = 2e-10) {
  const std::vector<double> actual = march(object, origin, direction);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "hit " << i;
}

inline void expect_uv(const ObjectRef& object, const Vec3& origin, const Vec3& direction, const Vec2& uv) {
  const auto shape = compile(*object);
  Hit hit;
  ASSERT_TRUE(shape->intersect({origin, direction}, RayKind::camera, 1e-4, 1e7, hit));
  EXPECT_NEAR(shape->uv(hit).x, uv.x, 1e-5);
  EXPECT_NEAR(shape->uv(hit).y, uv.y, 1e-5);
}

// Everything is asked of an object of any numbers: nothing crashes or hangs, whatever the answers are.
inline void ask_everything(const ObjectRef& object) {
  const auto shape = compile(*object);
  HitList hits;
  shape->intersect_all({{0.1, 0.2, -5}, {0, 0, 1}}, RayKind::camera, hits);
  for (const Hit& hit : hits) hit.shape->normal(hit);
  shape->inside({0.1, 0.2, 0.3});
}

inline bool inside(const ObjectRef& object, const Vec3& p) { return query::Target(object).inside(p); }

inline void expect_extent(const ObjectRef& object, const Vec3& low, const Vec3& high) {
  const Vec3 l = scene::low_corner(object->bounds), h = scene::high_corner(object->bounds);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FLOAT_EQ(static_cast<float>(l[i]), static_cast<float>(low[i])) << "low " << i;
    EXPECT_FLOAT_EQ(static_cast<float>(h[i]), static_cast<float>(high[i])) << "high " << i;
  }
}

// What every solid promises, on random rays: nearest and all-hits queries agree, every hit is where `distance` says the
// surface is, the normal is unit length, and intersections come in pairs that separate inside from outside.
struct SolidChecks {
  std::function<double(const Vec3&)> residual;  // zero on the surface, about the distance near it
  double tolerance = 1e-6;
  bool parity = true;
  int rays = 2000;
  double radius = 4;  // rays start on a sphere of this size and aim near the origin
};

inline Vec3 random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  for (;;) {
    const Vec3 v(normal(random), normal(random), normal(random));
    if (length(v) > 1e-3) return normalize(v);
  }
}

inline void check_solid(const ObjectRef& object, const SolidChecks& checks) {
  const auto shape = compile(*object);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-1, 1);
  int hits_seen = 0;
  for (int i = 0; i < checks.rays; ++i) {
    const Vec3 origin = random_unit(random) * checks.radius;
    const Vec3 target = Vec3(offset(random), offset(random), offset(random)) * (0.4 * checks.radius);
    const Ray ray{origin, normalize(target - origin)};
    HitList hits;
    shape->intersect_all(ray, RayKind::camera, hits);
    Hit nearest;
    const bool found = shape->intersect(ray, RayKind::camera, 1e-4, 1e10, nearest);
    double closest = 1e10;
    for (const Hit& hit : hits) {
      ++hits_seen;
      EXPECT_EQ(hit.shape->object, object.get());
      ASSERT_NEAR(length(hit.point - ray.at(hit.t)), 0, 1e-8);
      if (checks.residual) {
        ASSERT_NEAR(checks.residual(hit.point), 0, checks.tolerance) << "ray " << i;
      }
      ASSERT_NEAR(length(hit.shape->normal(hit)), 1, 1e-9);
      ASSERT_TRUE(hit.shape->bounds().intersects(hit.point));
      if (hit.t >= 1e-4) closest = std::min(closest, hit.t);
    }
    ASSERT_EQ(found, closest < 1e10) << "ray " << i;
    if (found) {
      ASSERT_EQ(nearest.t, closest) << "ray " << i;
    }
    if (!checks.parity) continue;
    std::vector<double> t{0};
    for (const Hit& hit : hits) t.push_back(hit.t);
    std::sort(t.begin(), t.end());
    t.push_back(t.back() + 1);
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
      if (t[k + 1] - t[k] < 1e-4) continue;
      ASSERT_EQ(shape->inside(ray.at((t[k] + t[k + 1]) / 2)), k % 2 == 1)
          << "ray " << i << " interval " << k << " of " << t.size();
    }
  }
  EXPECT_GT(hits_seen, 0);
}

}  // namespace verisim::shapes::testing
