// Probes 1 to 8 of spec 04 and properties of the tree.
#include <gtest/gtest.h>

#include <random>

#include "tracer/shapes/mesh/mesh_geometry.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

constexpr RayKind kQuery = RayKind::query;

scene::MeshTriangle triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool smooth = false) {
  scene::MeshTriangle t;
  t.vertex = t.normal = t.uv = {a, b, c};
  t.smooth = smooth;
  return t;
}
// mesh2 rounds its vertices when they are read.
Vec3 rounded(const Vec3& v) { return {double(float(v.x)), double(float(v.y)), double(float(v.z))}; }
scene::Object mesh(scene::MeshData data) {
  scene::Object o;
  o.shape = scene::Mesh{std::make_shared<const scene::MeshData>(std::move(data)), {}};
  return o;
}
scene::MeshData single(const Vec3& a, const Vec3& b, const Vec3& c) {
  scene::MeshData d;
  d.vertices = {a, b, c};
  d.triangles = {triangle(0, 1, 2)};
  return d;
}
void expect_near(const Vec3& a, const Vec3& b, double tolerance = 2e-15) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}
std::optional<Hit> trace(const Shape& s, const Vec3& o, const Vec3& d) {
  Hit hit;
  if (!s.intersect({o, normalize(d)}, kQuery, 1e-4, 1e20, hit)) return std::nullopt;
  return hit;
}

TEST(Mesh, FlatTriangleFromWrittenAndFromRoundedVertices) {
  const Vec3 a(.1, .2, .3), b(1.1, .2, .7), c(.1, 1.2, .5);
  const auto m = mesh(single(a, b, c)), m2 = mesh(single(rounded(a), rounded(b), rounded(c)));
  const auto s = compile(m), s2 = compile(m2);
  const auto hit = trace(*s, {.3, .4, -5}, {0, 0, 1}), hit2 = trace(*s2, {.3, .4, -5}, {0, 0, 1});
  ASSERT_TRUE(hit && hit2);
  EXPECT_NEAR(hit->point.z, 0.419999992817703, 2e-15);
  EXPECT_NEAR(hit2->point.z, 0.419999992817703, 2e-15);
  expect_near(s->normal(*hit), {0.365148365497589, 0.182574182748795, -0.912870943546295});
  expect_near(s2->normal(*hit2), {0.365148335695267, 0.182574167847633, -0.912870943546295});
}

// Spec 08 C: the hits that a ray along z has with sheets of which the second and the third have boxes that begin beyond
// the first.
std::vector<double> hits_of_sheets(scene::Object o) {
  const auto shape = compile(o);
  HitList hits;
  shape->intersect_all({{0, 0, -1}, {0, 0, 1}}, kQuery, hits);
  std::vector<double> t;
  for (const Hit& hit : hits) t.push_back(hit.t);
  std::sort(t.begin(), t.end());
  return t;
}
scene::MeshData sheets() {
  scene::MeshData d;
  for (const double z : {0.0, 1.0, 2.0}) {
    const auto first = static_cast<std::uint32_t>(d.vertices.size());
    for (const Vec3& v : {Vec3(-1, -1, z), Vec3(1, -1, z), Vec3(0, 1, z)}) d.vertices.push_back(v);
    d.triangles.push_back(triangle(first, first + 1, first + 2));
  }
  return d;
}

TEST(Mesh, WithoutInsideVectorHitsBeyondTheOneFoundLastDoNotExist) {
  EXPECT_EQ(hits_of_sheets(mesh(sheets())), std::vector<double>{1});
  scene::Object off = mesh(sheets());
  off.hierarchy = false;
  EXPECT_EQ(hits_of_sheets(off), (std::vector<double>{1, 2, 3}));
  scene::MeshData solid = sheets();
  solid.inside_vector = Vec3(0, 0, 1);
  EXPECT_EQ(hits_of_sheets(mesh(solid)), (std::vector<double>{1, 2, 3}));
}

TEST(Mesh, HitNearerThanTheCallerTakesHidesTheOthers) {
  const auto o = mesh(sheets());
  const auto shape = compile(o);
  const Ray ray{{0, 0, -5e-5}, {0, 0, 1}};
  Hit hit;
  EXPECT_FALSE(shape->intersect(ray, kQuery, 1e-4, 1e20, hit));
  EXPECT_FALSE(shape->occludes(ray, 1e-4, 1e20));
  ASSERT_TRUE(shape->intersect(ray, kQuery, 1e-5, 1e20, hit));
  EXPECT_NEAR(hit.t, 5e-5, 1e-12);
}

scene::MeshData smooth_corner() {
  scene::MeshData d;
  d.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  d.normals = {normalize({-1, 0, -2}), normalize({1, 0, -2}), normalize({0, 1, -2})};
  d.triangles = {triangle(0, 1, 2, true)};
  return d;
}

TEST(Mesh, SmoothTriangle) {
  const auto m = mesh(smooth_corner());
  const auto s = compile(m);
  const auto at = [&](double x, double y) { return trace(*s, {x, y, -5}, {0, 0, 1}); };
  expect_near(s->normal(*at(.3, .4)), {-0.000000040913014, 0.196116135138184, -0.980580675690919});
  expect_near(s->normal(*at(.5, 0)), {-0.000000029802322, 0, -1});
  expect_near(s->normal(*at(.5, .5)), {0.235702207321706, 0.235702263517504, -0.942809054070017});
  EXPECT_FALSE(at(.5, .5 + 1e-15));
}

// Of one triangle in a hundred another unit vector in single precision is what comes out when one is normalised again.
TEST(Mesh, NormalsAreOfLengthOneAlready) {
  const auto in_single = [](const Vec3& v) {
    return Vec3(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
  };
  scene::MeshData d = smooth_corner();
  d.vertices = {in_single({4.1, 2.721863, -0.121477}), in_single({4.1, 3.278137, -0.121477}),
                in_single({4.9, 3, 0.194053})};
  d.normals = {in_single(normalize({0.163310, 0.228216, -0.959816})),
               in_single(normalize({0.163310, -0.228216, -0.959816})),
               in_single(normalize({-0.057265, -0.265469, -0.962417}))};
  const auto s = compile(mesh(d));
  const Vec3 n = s->normal(*trace(*s, {4.5, 3.0900000000000003, -20}, {0, 0, 1}));
  EXPECT_NEAR(n.x, 0.0538575208599623018, 1e-16);
  EXPECT_NEAR(n.y, -0.2098343194737121165, 1e-16);
  EXPECT_NEAR(n.z, -0.9762524908126086753, 1.2e-16);
}

TEST(Mesh, SmoothTriangleTransformed) {
  auto m = mesh(smooth_corner());
  m.transform =
      Transform::scaling({2, 1, 1}).then(Transform::rotation({0, 30, 0})).then(Transform::translation({1, 2, 3}));
  const auto s = compile(m);
  const auto hit = trace(*s, {1.5, 2.3, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, 2.711324865405187, 2e-15);
  expect_near(s->normal(*hit), {-0.520489608726731, 0.148272300612797, -0.840895886586730});
}

TEST(Mesh, DistanceLimitsAreLocal) {
  const auto at = [](double size, std::optional<double> scale, double z) {
    auto m = mesh(single({-size, -size, 0}, {size, -size, 0}, {0, size, 0}));
    if (scale) m.transform = Transform::scaling(Vec3(*scale));
    const auto s = compile(m);
    return trace(*s, {0.01, 0.01, z}, {0, 0, 1}).has_value();
  };
  EXPECT_FALSE(at(1, std::nullopt, -5e-5));
  EXPECT_TRUE(at(1, std::nullopt, -2e-4));
  EXPECT_FALSE(at(4e-6, 1e6, -0.5));
  EXPECT_TRUE(at(4e-6, 1e6, -1.5));
  EXPECT_TRUE(at(4e5, 1e-5, -99));
  EXPECT_FALSE(at(4e5, 1e-5, -101));
}

TEST(Mesh, EqualNormalsAreDiscarded) {
  auto d = smooth_corner();
  d.normals.assign(3, normalize({1, 0, -1}));
  const auto m = mesh(d);
  const auto s = compile(m);
  expect_near(s->normal(*trace(*s, {.2, .2, -5}, {0, 0, 1})), {0, 0, -1});
}

TEST(Mesh, InsideVectorIsAWorldDirection) {
  auto d = single({-1, -1, 1}, {3, -1, 1}, {-1, 3, 1});
  d.inside_vector = Vec3(0, 0, 1);
  auto m = mesh(d);
  const auto s = compile(m);
  EXPECT_TRUE(s->inside({0, 0, 0}));
  EXPECT_FALSE(s->inside({0, 0, 1.5}));
  m.transform = Transform::rotation({0, 180, 0});
  const auto turned = compile(m);
  EXPECT_FALSE(turned->inside({0, 0, 0}));
  EXPECT_TRUE(turned->inside({0, 0, -2}));
}

scene::MeshData cube() {
  scene::MeshData d;
  for (int i = 0; i < 8; ++i) d.vertices.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    const auto v = [&](int k) { return static_cast<std::uint32_t>(f[k]); };
    d.triangles.push_back(triangle(v(0), v(1), v(2))), d.triangles.push_back(triangle(v(0), v(2), v(3)));
  }
  d.inside_vector = Vec3(0, 0, 1);
  return d;
}

TEST(Mesh, AnIntersectionThroughASharedEdgeCountsTwice) {
  const auto m = mesh(cube());
  const auto s = compile(m);
  EXPECT_FALSE(s->inside({.5, .5, .5}));
  EXPECT_TRUE(s->inside({.5, .4, .5}));
  EXPECT_FALSE(s->inside({.5, .4, 1.5}));
  EXPECT_FALSE(s->inside({1.5, .4, .5}));
}

TEST(Mesh, WeightsAreBarycentricUnlessTheTriangleIsTiny) {
  for (const double size : {1.0, 0.01, 0.003, 0.001, 0.0001}) {
    const MeshGeometry g(
        std::make_shared<const scene::MeshData>(single({0, 0, 0}, {3 * size, 0, 0}, {0, 3 * size, 0})));
    const auto w = g.weights(0, {0.5625 * size, 0.75 * size, 0});
    const float sum = w[0] + w[1] + w[2];
    if (size >= 0.003) {
      EXPECT_NEAR(w[0] / sum, 0.5625f, 1e-6);
      EXPECT_NEAR(w[1] / sum, 0.1875f, 1e-6);
      EXPECT_NEAR(w[2] / sum, 0.25f, 1e-6);
    } else {
      for (const float v : w) EXPECT_NEAR(v / sum, 1 / 3.0f, 1e-6);
    }
  }
}

TEST(Mesh, UvIsAffine) {
  scene::MeshData d = single({0, 0, 0}, {3, 0, 0}, {3, 3, 0});
  d.triangles[0].has_uv = true;
  d.uvs = {{1, 1}, {1, 0}, {0.3, 0.9}};
  const auto m = mesh(d);
  const auto s = compile(m);
  const auto hit = trace(*s, {2, 1, -5}, {0, 0, 1});
  const Vec2 uv = s->uv(*hit);
  EXPECT_NEAR(uv.x, 1.0 / 3 + 1.0 / 3 + 0.1, 1e-15);
  EXPECT_NEAR(uv.y, 1.0 / 3 + 0.3, 1e-15);
}

// The tree must find exactly what testing every triangle finds: along edges, from far away, with tiny triangles.
TEST(Mesh, TreeLosesNothing) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double offset : {0.0, 1000.0}) {
    scene::MeshData d;
    constexpr int n = 40;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) d.vertices.push_back(rounded({offset + i * 0.1, 0.2 * unit(rng), j * 0.1}));
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = i * (n + 1) + j;
        d.triangles.push_back(triangle(a, a + 1, a + n + 1)),
            d.triangles.push_back(triangle(a + 1, a + n + 2, a + n + 1));
      }
    }
    const MeshGeometry g(std::make_shared<const scene::MeshData>(d));
    ASSERT_EQ(g.tree().order().size(), d.triangles.size());
    int hits = 0, aimed = 0;
    for (int k = 0; k < 2000; ++k) {
      // Half of the rays are aimed at vertices and edge points.
      const Vec3 v = d.vertices[rng() % d.vertices.size()], w = d.vertices[rng() % d.vertices.size()];
      const Vec3 target = k % 2 ? v : v + 0.5 * (w - v);
      const double distance = k % 3 == 0 ? 1 : k % 3 == 1 ? 1e3 : 1e6;
      const Vec3 direction = normalize(Vec3(unit(rng), unit(rng), k % 5 == 0 ? 0 : unit(rng)));
      const Vec3 origin = target - distance * direction;
      int by_tree = 0, by_test = 0;
      double nearest_tree = 1e9, nearest_test = 1e9;
      g.tree().traverse_leaves({origin, direction}, 0, 1e7,
                               [&](std::uint32_t first, std::uint32_t count, double limit) {
                                 for (std::uint32_t i = first; i < first + count; ++i) {
                                   const double t = g.hit(i, origin, direction);
                                   if (t >= 0) ++by_tree, nearest_tree = std::min(nearest_tree, t);
                                 }
                                 return limit;
                               });
      for (std::uint32_t i = 0; i < d.triangles.size(); ++i) {
        const double t = g.hit(i, origin, direction);
        if (t >= 0) ++by_test, nearest_test = std::min(nearest_test, t);
      }
      ASSERT_EQ(by_tree, by_test) << k;
      ASSERT_EQ(nearest_tree, nearest_test);
      hits += by_test, ++aimed;
    }
    EXPECT_GT(hits, aimed / 4);
  }
}

TEST(Mesh, HostileInput) {
  scene::MeshData empty;
  const auto none = mesh(empty);
  EXPECT_FALSE(trace(*compile(none), {0, 0, -5}, {0, 0, 1}));
  const double nan = std::nan(""), inf = 1 / 0.0;
  auto d = single({nan, 0, 0}, {inf, 0, 0}, {0, 1, 0});
  d.vertices.insert(d.vertices.end(), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  d.triangles.push_back(triangle(3, 4, 5));   // without area
  d.triangles.push_back(triangle(0, 1, 99));  // index out of range
  d.triangles.push_back(triangle(3, 4, 6));
  const auto m = mesh(d);
  const auto s = compile(m);
  EXPECT_TRUE(trace(*s, {.2, .2, -5}, {0, 0, 1}));
  EXPECT_FALSE(trace(*s, {.2, .2, -5}, {nan, 0, 1}));
}

TEST(Mesh, CoincidentTrianglesMakeNoEndlessTree) {
  auto d = single({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  d.triangles.assign(5000, d.triangles[0]);
  auto m = mesh(d);
  HitList hits;
  compile(m)->intersect_all({{.2, .2, -5}, {0, 0, 1}}, kQuery, hits);
  EXPECT_EQ(hits.size(), 5000u);
  // Of all that are hit at the same distance the last one is seen, if no tree tells the order.
  m.hierarchy = false;
  Hit hit;
  ASSERT_TRUE(compile(m)->intersect({{.2, .2, -5}, {0, 0, 1}}, kQuery, 0, 1e7, hit));
  const auto geometry = MeshGeometry::of(std::get<scene::Mesh>(m.shape).data);
  EXPECT_EQ(geometry->triangle(static_cast<std::uint32_t>(hit.part)).id(), 4999u);
}

TEST(Mesh, CopiesShareTheirGeometry) {
  const auto data = std::make_shared<const scene::MeshData>(smooth_corner());
  EXPECT_EQ(MeshGeometry::of(data), MeshGeometry::of(data));
}

}  // namespace
}  // namespace verisim::shapes
