// What every surface promises under any transformation: 100 random ones with 100 random rays each. Every hit satisfies
// the surface's equation, its normal is the gradient, and intersections of a solid separate inside from outside.
#pragma once

#include <algorithm>

#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {

struct Solid {
  const char* name;
  std::function<ObjectRef(const Steps&)> build;
  std::function<double(const Vec3&)>
      value;  // in the shape's own space: zero on the surface, about the distance near it; may be empty
  double tolerance = 1e-6;
  bool parity = true;
  double shortest = 1e-3;  // intervals of which it is told whether they are inside
};

inline Transform random_transform(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1), size(0.5, 1.5), angle(-180, 180);
  const auto sign = [&] { return unit(random) < -0.4 ? -1.0 : 1.0; };
  Mat4 shear;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (i != k) shear[i][k] = 0.3 * unit(random);
  return Transform::rotation({angle(random), angle(random), angle(random)})
      .then(Transform::scaling({sign() * size(random), sign() * size(random), sign() * size(random)}))
      .then(Transform::from_matrix(shear))
      .then(Transform::rotation({angle(random), angle(random), angle(random)}))
      .then(Transform::translation({unit(random), unit(random), unit(random)}));
}

// The gradient of value in world space, or nothing near edges, where it jumps.
inline std::optional<Vec3> gradient(const Solid& solid, const Transform& t, const Vec3& p) {
  const auto differences = [&](double h) {
    Vec3 g;
    for (int i = 0; i < 3; ++i) {
      Vec3 a = p, b = p;
      a[i] -= h, b[i] += h;
      g[i] = (solid.value(t.inverse_point(b)) - solid.value(t.inverse_point(a))) / (2 * h);
    }
    return g;
  };
  const Vec3 fine = differences(1e-6), coarse = differences(1e-4);
  if (!(length(fine - coarse) < 1e-4 * length(fine))) return std::nullopt;
  return normalize(fine);
}

inline void check(const Solid& solid, std::mt19937& random, int& hits_seen, int& normals_seen) {
  const Transform t = random_transform(random);
  const ObjectRef object = solid.build([&](Object& o) { scene::transform(o, t); });
  const auto shape = compile(*object);
  std::uniform_real_distribution<double> offset(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 origin = t.point(Vec3(0)) + 6.0 * random_unit(random);
    const Ray ray{origin, normalize(t.point({offset(random), offset(random), offset(random)}) - origin)};
    HitList hits;
    shape->intersect_all(ray, RayKind::camera, hits);
    std::vector<double> depths{0};
    for (const Hit& hit : hits) {
      ++hits_seen;
      depths.push_back(hit.t);
      const Vec3 n = hit.shape->normal(hit);
      ASSERT_NEAR(length(n), 1, 1e-9);
      ASSERT_TRUE(hit.shape->bounds().intersects(hit.point));
      if (!solid.value) continue;
      ASSERT_NEAR(solid.value(t.inverse_point(hit.point)), 0, solid.tolerance) << "ray " << i;
      if (const auto g = gradient(solid, t, hit.point)) {
        ++normals_seen;
        ASSERT_GT(std::fabs(dot(*g, n)), 1 - 1e-4) << "ray " << i;
      }
    }
    Hit nearest;
    const bool found = shape->intersect(ray, RayKind::camera, 1e-4, 1e7, nearest);
    ASSERT_EQ(found, !hits.empty()) << "ray " << i;
    std::sort(depths.begin(), depths.end());
    if (found) {
      ASSERT_NEAR(nearest.t, depths[1], 1e-9 * depths[1]) << "ray " << i;
    }
    if (!solid.parity) continue;
    depths.push_back(depths.back() + 1);
    for (std::size_t k = 0; k + 1 < depths.size(); ++k) {
      if (depths[k + 1] - depths[k] < solid.shortest) continue;
      ASSERT_EQ(shape->inside(ray.at((depths[k] + depths[k + 1]) / 2)), k % 2 == 1)
          << "ray " << i << " interval " << k << " of " << depths.size();
    }
  }
}

inline void check_all(const std::vector<Solid>& solids, int least_hits) {
  for (const Solid& solid : solids) {
    SCOPED_TRACE(solid.name);
    std::mt19937 random(11);
    int hits = 0, normals = 0;
    for (int n = 0; n < 100 && !::testing::Test::HasFatalFailure(); ++n) check(solid, random, hits, normals);
    EXPECT_GT(hits, least_hits);
    if (solid.value) {
      EXPECT_GT(normals, hits / 2);
    }
  }
}

}  // namespace verisim::shapes::testing
