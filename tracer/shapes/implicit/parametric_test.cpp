// Probes 20, 21 and 35 of spec 04.
#include <numbers>

#include "tracer/shapes/trace_test_support.h"

namespace verisim::shapes {
namespace {

using namespace test;
using std::numbers::pi;

template <class F>
FunctionPtr uv(F f) {
  return std::make_shared<Callable<2>>([f](const double* a) { return f(a[0], a[1]); });
}

scene::Parametric plane() {
  scene::Parametric p;
  p.function = {uv([](double u, double) { return u; }), uv([](double, double v) { return v; }),
                uv([](double, double) { return 0.0; })};
  p.low = {-1, -1}, p.high = {1, 1};
  return p;
}
scene::Parametric sphere(double r) {
  scene::Parametric p;
  p.function = {uv([r](double u, double v) { return r * std::sin(u) * std::cos(v); }),
                uv([r](double u, double v) { return r * std::sin(u) * std::sin(v); }),
                uv([r](double u, double) { return r * std::cos(u); })};
  p.low = {0, 0}, p.high = {pi, 2 * pi};
  p.container = {true, Vec3(0), Vec3(0), {0, 0, 0}, 1.1};
  p.accuracy = 0.001, p.max_gradient = 1;
  return p;
}

TEST(Parametric, Plane) {
  auto p = plane();
  const auto hit = trace(object(p), {.3, .4, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, -0.0019765625, 1e-14);
  EXPECT_VEC_NEAR(hit->normal, Vec3(0, 0, 1), 1e-12);
  EXPECT_VEC_NEAR(trace(object(p), {.3, .4, -5}, {.1, .05, 1})->point,
                  Vec3(0.79980234375, 0.649901171875, -0.0019765625), 1e-13);
  p.accuracy = 0.01;
  EXPECT_NEAR(trace(object(p), {.3, .4, -5}, {0, 0, 1})->point.z, -0.0178125, 1e-14);
  p = plane();
  p.max_gradient = 2, p.low = {1, 1}, p.high = {0, 0};
  EXPECT_NEAR(trace(object(p), {.3, .4, -5}, {0, 0, 1})->point.z, -0.002953125, 1e-14);
}

TEST(Parametric, SphereWithAndWithoutTables) {
  for (const int depth : {0, 10}) {
    auto p = sphere(1);
    p.precompute_depth = depth;
    p.precompute = {true, true, true};
    const auto hit = trace(object(p), {.3, .4, -5}, {0, 0, 1});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->point.z, -0.867472574314302, 1e-14);
    EXPECT_VEC_NEAR(hit->normal, Vec3(0.300379981953389, 0.400280753213620, -0.865763931478102), 1e-11);
    EXPECT_NEAR(trace(object(p), {-5, .1, .2}, {1, 0, 0})->point.x, -0.976205569904502, 1e-14);
  }
  auto p = sphere(1);
  p.accuracy = 1e-4;
  EXPECT_NEAR(trace(object(p), {.3, .4, -5}, {0, 0, 1})->point.z, -0.866165344788491, 1e-14);
  p.accuracy = 1e-6;
  EXPECT_NEAR(trace(object(p), {.3, .4, -5}, {0, 0, 1})->point.z, -0.866026840709075, 1e-14);
}

TEST(Parametric, ASphereContainerHidesTheSurfaceFromInside) {
  auto p = sphere(0.5);
  p.max_gradient = 0.5;
  EXPECT_FALSE(trace(object(p), {.05, .02, .1}, {.1, .2, 1}));
  p.container = {false, Vec3(-1.1), Vec3(1.1), Vec3(0), 1};
  const auto hit = trace(object(p), {.05, .02, .1}, {.1, .2, 1});
  ASSERT_TRUE(hit);
  EXPECT_VEC_NEAR(hit->point, Vec3(0.088086075619620, 0.096172151239239, 0.480860756196195), 1e-13);
}

TEST(Parametric, ZeroAccuracyEnds) {
  auto p = plane();
  p.accuracy = 0;
  p.max_gradient = 0;
  trace(object(p), {.3, .4, -5}, {0, 0, 1});
  p.function[2] = uv([](double, double) { return std::nan(""); });
  EXPECT_FALSE(trace(object(p), {.3, .4, -5}, {0, 0, 1}));
}

}  // namespace
}  // namespace verisim::shapes
