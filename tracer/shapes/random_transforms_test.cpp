// What every solid promises under any transformation: 100 random ones with 100 random rays each. Every hit satisfies the solid's equation, its normal is the
// gradient, and crossings separate inside from outside.
#include <algorithm>

#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

struct Solid {
  const char* name;
  std::function<ObjectRef(const Steps&)> build;
  std::function<double(const Vec3&)> value;  // in the shape's own space: zero on the surface, about the distance near it; may be empty
  double tolerance = 1e-6;
  bool parity = true;
};

double p_norm(double a, double b, double p) { return std::pow(std::pow(std::fabs(a), p) + std::pow(std::fabs(b), p), 1 / p); }

std::vector<Solid> solids() {
  using scene::SplineKind;
  const auto shared = [](auto shape) { return [shape](const Steps& m) { return make_shared_shape(shape, m); }; };
  const auto plain = [](auto shape) { return [shape](const Steps& m) { return make(shape, m); }; };
  scene::Blob blob;
  blob.threshold = 0.5;
  blob.components = {{Vec3(-0.5, 0, 0), Vec3(0), 1, 1, false, {}, {}}, {Vec3(0.6, 0.1, 0), Vec3(0), 1.1, 0.9, false, {}, {}}, {Vec3(0, 0.8, 0.2), Vec3(0), 0.6, -0.7, false, {}, {}}};
  const auto field = [blob](const Vec3& p) {
    double sum = 0;
    for (const auto& c : blob.components) {
      const Vec3 d = p - c.a;
      const double q = dot(d, d) / (c.radius * c.radius);
      if (q < 1) sum += c.strength * (1 - q) * (1 - q);
    }
    return blob.threshold - sum;
  };
  std::vector<double> rounded_cube(35, 0.0);
  rounded_cube[0] = rounded_cube[20] = rounded_cube[30] = 1, rounded_cube[34] = -1;
  return {
      {"sphere", plain(scene::Sphere{{0.1, -0.2, 0.3}, 0.9}), [](const Vec3& p) { return length(p - Vec3(0.1, -0.2, 0.3)) - 0.9; }},
      {"box", plain(scene::Box{{-1, -0.7, -0.5}, {0.8, 0.9, 1}}),
       [](const Vec3& p) { return std::max({-1 - p.x, p.x - 0.8, -0.7 - p.y, p.y - 0.9, -0.5 - p.z, p.z - 1}); }},
      {"cylinder", plain(scene::Cone{{0, -1, 0}, {0, 0.8, 0}, 0.6, 0.6, false}),
       [](const Vec3& p) { return std::max({std::hypot(p.x, p.z) - 0.6, -1 - p.y, p.y - 0.8}); }},
      {"cone", plain(scene::Cone{{0, -1, 0}, {0, 1, 0}, 1, 0.4, false}),
       [](const Vec3& p) { return std::max({std::hypot(p.x, p.z) - 0.7 + 0.3 * p.y, -1 - p.y, p.y - 1}); }},
      {"torus", plain(scene::Torus{0.9, 0.35}), [](const Vec3& p) { return std::hypot(std::hypot(p.x, p.z) - 0.9, p.y) - 0.35; }, 1e-5, false},
      {"quadric", plain(scene::Quadric{{1, 0.5, 1.5}, {0.2, -0.1, 0.3}, {0.1, -0.2, 0}, -1}),
       [](const Vec3& p) {
         return (p.x * p.x + 0.5 * p.y * p.y + 1.5 * p.z * p.z + 0.2 * p.x * p.y - 0.1 * p.x * p.z + 0.3 * p.y * p.z + 0.1 * p.x - 0.2 * p.y - 1) / 2;
       }},
      {"quartic", plain(scene::Poly{4, rounded_cube}),
       [](const Vec3& p) { return std::sqrt(std::sqrt(p.x * p.x * p.x * p.x + p.y * p.y * p.y * p.y + p.z * p.z * p.z * p.z)) - 1; }, 1e-4, false},
      {"superellipsoid, convex", plain(scene::Superellipsoid{0.4, 0.8}), [](const Vec3& p) { return p_norm(p_norm(p.x, p.y, 5), p.z, 2.5) - 1; }},
      {"superellipsoid, pinched", plain(scene::Superellipsoid{2.5, 1}), [](const Vec3& p) { return p_norm(p_norm(p.x, p.y, 0.8), p.z, 2) - 1; }, 1e-6, false},
      {"blob", shared(blob), field, 1e-6, false},
      {"ovus", plain(scene::Ovus{0.9, 0.5}), {}},
      {"lathe", shared(scene::Lathe{SplineKind::cubic, {{-0.5, -1}, {0, -1}, {1, -0.2}, {0.5, 0.4}, {0, 1}, {0, 1.5}}}), {}},
      {"sor", shared(scene::Sor{{{0.5, -2}, {0.5, -1}, {1, -0.3}, {0.4, 0.4}, {0.6, 1}, {0.6, 2}}, false}), {}},
      {"prism", shared(scene::Prism{SplineKind::linear, false, false, -0.8, 0.7, {{-1, -1}, {1, -1}, {0.2, 0.1}, {-1, 1.1}, {-1, -1}}}), {}},
      {"sphere_sweep", shared(scene::SphereSweep{SplineKind::linear, {{-1, 0, 0}, {0.8, 0.3, 0.2}}, {0.4, 0.6}, 1e-6}), {}, 1e-6, false},
  };
}

Transform random_transform(std::mt19937& random) {
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
std::optional<Vec3> gradient(const Solid& solid, const Transform& t, const Vec3& p) {
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

void check(const Solid& solid, std::mt19937& random, int& hits_seen, int& normals_seen) {
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
      if (depths[k + 1] - depths[k] < 1e-3) continue;
      ASSERT_EQ(shape->inside(ray.at((depths[k] + depths[k + 1]) / 2)), k % 2 == 1) << "ray " << i << " interval " << k << " of " << depths.size();
    }
  }
}

TEST(RandomTransforms, HitsLieOnTheSurfaceWithItsNormalAndSeparateInsideFromOutside) {
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    std::mt19937 random(11);
    int hits = 0, normals = 0;
    for (int n = 0; n < 100 && !HasFatalFailure(); ++n) check(solid, random, hits, normals);
    EXPECT_GT(hits, 5000);
    if (solid.value) {
      EXPECT_GT(normals, hits / 2);
    }
  }
}

}  // namespace
}  // namespace verisim::shapes::testing
