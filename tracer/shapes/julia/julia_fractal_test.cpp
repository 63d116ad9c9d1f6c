// Probes 22 to 24 of spec 04.
#include <random>

#include "tracer/scene/bounds.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/trace_test_support.h"

namespace verisim::shapes {
namespace {

using namespace test;

scene::JuliaFractal quaternion() {
  scene::JuliaFractal f;
  f.parameter = {-0.083, 0.0, -0.83, -0.025};
  f.max_iteration = 8;
  f.precision = 15;
  return f;
}

TEST(JuliaFractal, Quaternion) {
  const auto o = object(quaternion());
  const auto hit = trace(o, {.1, .2, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, -0.341339583216304, 1e-14);
  EXPECT_VEC_NEAR(hit->normal, Vec3(0.854707628308641, 0.141787631672129, -0.499370741649755), 1e-12);
  EXPECT_NEAR(trace(o, {.1, -5, .2}, {0, 1, 0})->point.y, -0.962490144506840, 1e-14);
  EXPECT_TRUE(compile(o)->inside({.1, .1, .1}));
}

TEST(JuliaFractal, QuaternionCube) {
  scene::JuliaFractal f = quaternion();
  f.parameter = {-0.162, 0.163, 0.560, -0.599};
  f.function = scene::JuliaFunction::cube;
  const auto hit = trace(object(f), {.1, .2, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, -0.650016255093803, 1e-14);
  EXPECT_VEC_NEAR(hit->normal, Vec3(0.914885225406269, 0.087255735589366, -0.394171867261070), 1e-12);
  EXPECT_NEAR(julia_fractal_box(f).max.x, 1.851595044136047, 1e-7);
}

TEST(JuliaFractal, Hypercomplex) {
  scene::JuliaFractal f = quaternion();
  f.hypercomplex = true;
  const auto hit = trace(object(f), {.1, .2, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, -0.235598197106588, 1e-14);
  EXPECT_VEC_NEAR(hit->normal, Vec3(0.622886037469728, 0.553172035354207, -0.553185035614075), 1e-12);
  f.function = scene::JuliaFunction::cube;
  EXPECT_NEAR(trace(object(f), {.1, .2, -5}, {0, 0, 1})->point.z, -0.235598178554970, 1e-14);
}

// Rays whose first step hangs on the last bit of |h|^2 on the bounding sphere; hit or missed as POV-Ray's trace() says.
TEST(JuliaFractal, TheFirstStepIsPovRays) {
  scene::JuliaFractal f;
  f.parameter = {0.2, 0.1, 0.59, -0.2};
  f.max_iteration = 7;
  f.precision = 20;
  f.hypercomplex = true;
  const auto o = object(f);
  const auto shape = compile(o);
  struct Probe {
    int x, y;
    bool hit;
  };
  for (const auto& [x, y, expected] :
       {Probe{43, 33, false}, {12, 35, true}, {21, 35, false}, {25, 39, false}, {21, 48, false}}) {
    const Vec3 d(-0.6 + x * 0.02, -0.45 + y * 0.015, 2.2);
    Hit hit;
    EXPECT_EQ(shape->intersect({{0, 0, -6}, d * (1 / length(d))}, RayKind::query, 1e-4, 1e7, hit), expected)
        << x << ", " << y;
  }
}

// Distances measured with a plane moved along the ray until POV-Ray's trace() of the union with the fractal found the
// other one.
TEST(JuliaFractal, LaterHitsAreCountedAsNearerThanTheirPoints) {
  const Vec3 d = normalize(Vec3(-0.00226914, -0.173517, 0.984828)), o = Vec3(0, 1.5, -6) + 4.0 * d;
  HitList hits;
  const auto shape = compile(object(quaternion()));
  shape->join_csg();
  shape->intersect_all({o, d}, RayKind::query, hits);
  ASSERT_GE(hits.size(), 3u);
  EXPECT_NEAR(length(hits[0].point - o), hits[0].t, 1e-14);
  EXPECT_NEAR(length(hits[2].point - o), 1.913650444594353, 1e-12);
  EXPECT_NEAR(hits[2].t, 1.823674960382106, 1e-12);
}

TEST(JuliaFractal, OutsideCsgThereIsOnlyTheFirstHit) {
  HitList hits;
  compile(object(quaternion()))->intersect_all({{0, 0, -6}, {0, 0, 1}}, RayKind::query, hits);
  EXPECT_EQ(hits.size(), 1u);
}

// `trace` of POV-Ray: the normal hangs on what the search left behind the step at which the iteration escapes.
TEST(JuliaFractal, NormalsWhereTheIterationEscapesAreThoseOfTheSearch) {
  scene::JuliaFractal f;
  f.hypercomplex = true;
  f.function = scene::JuliaFunction::tan;
  f.parameter = {-0.31, -0.2, -0.27, -0.37};
  f.max_iteration = 5;
  f.slice_distance = 0.3;
  const auto hit = trace(object(f), {-1, -0.7, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_VEC_NEAR(hit->point, Vec3(-1.00000000000000, -0.70000000000000, -3.75919939094818), 1e-12);
  EXPECT_VEC_NEAR(hit->normal, Vec3(-0.1775066373451, -0.6324511057931, 0.7539873954381), 1e-10);
}

// trace() of POV-Ray.
TEST(JuliaFractal, InvertedItsNormalsStillPointOutwards) {
  scene::JuliaFractal f;
  f.parameter = {-0.2, 0.3, 0, 0};
  scene::Object inverted = object(f);
  scene::invert(inverted);
  const auto outside = trace(inverted, {0, 0, -4}, {0, 0, 1}), inside = trace(inverted, {0, 0, 0}, {0, 0, 1});
  ASSERT_TRUE(outside && inside);
  EXPECT_VEC_NEAR(outside->normal, Vec3(0, 0, -1), 1e-12);
  EXPECT_VEC_NEAR(inside->point, Vec3(0, 0, 0.997409166882), 1e-12);
  EXPECT_VEC_NEAR(inside->normal, Vec3(0, 0, 1), 1e-12);
}

// max_extent and inside() of POV-Ray.
TEST(JuliaFractal, SubtractedItBoundsAndMovedItIsKept) {
  scene::JuliaFractal f;
  f.parameter = {-0.3, 0.2, 0.1, 0};
  auto fractal = std::make_shared<scene::Object>(object(f));
  scene::compute_bounds(*fractal);
  scene::invert(*fractal);
  auto rest = std::make_shared<scene::Object>();
  auto& csg = std::get<scene::Csg>(rest->shape = scene::Csg{});
  csg.kind = scene::CsgKind::intersection;
  csg.children.push_back(box({-2, -1, -1}, {1, 1, 1}));
  csg.children.push_back(fractal);
  scene::compute_bounds(*rest);
  EXPECT_NEAR(scene::low_corner(rest->bounds).x, -1.374165838956833, 1e-6) << "the box of the fractal cuts";
  EXPECT_FALSE(compile(*rest)->inside({0, 0, 0}));
  scene::translate(*rest, {0, 0.001, 0});
  EXPECT_TRUE(compile(*rest)->inside({0, 0, 0})) << "a transformation puts its inside back";
}

TEST(JuliaFractal, HostileParametersEnd) {
  scene::JuliaFractal f = quaternion();
  f.parameter = {std::nan(""), 0, 0, 0};
  trace(object(f), {.1, .2, -5}, {0, 0, 1});
  for (int k = 0; k < 18; ++k) {
    scene::JuliaFractal g = quaternion();
    g.hypercomplex = true;
    g.function = static_cast<scene::JuliaFunction>(k);
    g.exponent = {-3, 1e300};
    trace(object(g), {.1, .2, -5}, {0, 0, 1});
    trace(object(g), {0, 0, 0}, {1, 0, 0});
  }
}

}  // namespace
}  // namespace verisim::shapes
