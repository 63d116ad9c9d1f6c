// Probes 14 to 19 of spec 04.
#include "tracer/functions/expression.h"
#include "tracer/functions/internal/formula_table.h"
#include "tracer/functions/narrowing.h"
#include "tracer/functions/test_support.h"
#include "tracer/shapes/trace_test_support.h"

namespace verisim::shapes {
namespace {

using namespace test;

constexpr double kTolerance = 2e-15;

scene::Isosurface iso(FunctionPtr f) {
  scene::Isosurface s;
  s.function = std::move(f);
  return s;
}
FunctionPtr ball() {
  return xyz([](double x, double y, double z) { return x * x + y * y + z * z - 0.7; });
}
FunctionPtr height() {
  return xyz([](double, double y, double) { return y; });
}

TEST(Isosurface, HitsAreGridPointsBehindTheSurface) {
  auto s = iso(ball());
  s.max_gradient = 3.6;
  const auto o = object(s);
  const auto hit = trace(o, {.1, .2, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, -0.8056640625, kTolerance);
  EXPECT_VEC_NEAR(hit->normal, Vec3(0.120241665399453, 0.239885113558095, -0.963326047709282), kTolerance);
  EXPECT_NEAR(trace(o, {.1, .2, 0}, {0, 0, 1})->point.z, 0.8066357421875, kTolerance);
  s.accuracy = 0.1;
  const auto rough = trace(object(s), {.1, .2, -5}, {0, 0, 1});
  EXPECT_NEAR(rough->point.z, -0.75, kTolerance);
  EXPECT_VEC_NEAR(rough->normal, Vec3(0.197814142018736, 0.329690236697894, -0.923132662754102), kTolerance);
  s.threshold = 0.7;
  s.function = xyz([](double x, double y, double z) { return x * x + y * y + z * z; });
  auto scaled = object(s);
  scaled.transform = Transform::scaling(Vec3(2));
  const auto large = trace(scaled, {.2, .4, -10}, {0, 0, 1});
  EXPECT_NEAR(large->point.z, -1.5625, kTolerance);
  EXPECT_VEC_NEAR(large->normal, Vec3(0.190542212380940, 0.317570353968233, -0.928893285357079), kTolerance);
}

TEST(Isosurface, ClosedAndOpenContainers) {
  auto s = iso(height());
  const auto closed = object(s);
  EXPECT_NEAR(trace(closed, {.1, 5, .3}, {0, -1, 0})->point.y, -0.0009765625, kTolerance);
  const auto below = trace(closed, {.1, -5, .3}, {0, 1, 0});
  EXPECT_EQ(below->point.y, -1);
  EXPECT_EQ(below->normal, Vec3(0, -1, 0));
  EXPECT_EQ(trace(closed, {-5, -.5, .3}, {1, 0, 0})->point.x, -1);
  EXPECT_NEAR(trace(closed, {.1, -.5, .3}, {0, 1, 0})->point.y, 0.00065673828125, kTolerance);
  EXPECT_EQ(trace(closed, {.1, -.5, .3}, {0, -1, 0})->point.y, -1);
  s.open = true;
  const auto open = object(s);
  EXPECT_NEAR(trace(open, {.1, 5, .3}, {0, -1, 0})->point.y, -0.0009765625, kTolerance);
  EXPECT_NEAR(trace(open, {.1, -5, .3}, {0, 1, 0})->point.y, 0.0009765625, kTolerance);
  EXPECT_FALSE(trace(open, {-5, -.5, .3}, {1, 0, 0}));
  EXPECT_NEAR(trace(open, {.1, -.5, .3}, {0, 1, 0})->point.y, 0.000244140625, kTolerance);
  EXPECT_FALSE(trace(open, {.1, -.5, .3}, {0, -1, 0}));
  const auto shape = compile(closed);
  EXPECT_TRUE(shape->inside({0, 0, 0}));
  EXPECT_FALSE(shape->inside({0, 1e-9, 0}));
}

TEST(Isosurface, SphereContainer) {
  auto s = iso(xyz([](double, double, double z) { return z; }));
  s.container = {true, Vec3(0), Vec3(0), {0, 0, 0}, 1};
  const auto o = object(s);
  const auto front = trace(o, {.1, .2, -5}, {0, 0, 1});
  EXPECT_NEAR(front->point.z, -0.974679434480896, kTolerance);
  EXPECT_VEC_NEAR(front->normal, Vec3(.1, .2, -0.974679434480896), kTolerance);
  EXPECT_NEAR(trace(o, {.1, .2, 5}, {0, 0, -1})->point.z, -0.000951835385235, kTolerance);
}

TEST(Isosurface, ClippingUsesUpTheHits) {
  auto s = iso(height());
  auto o = object(s);
  o.clipped_by = {box({-9, -.5, -9}, {9, 9, 9})};
  EXPECT_FALSE(trace(o, {.1, -5, .2}, {0, 1, 0}));
  for (const int n : {2, 0}) {
    s.max_trace = n;
    o.shape = std::make_shared<const scene::Isosurface>(s);
    const auto hit = trace(o, {.1, -5, .2}, {0, 1, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->point.y, 0.000067348480225, kTolerance);
  }
}

TEST(Isosurface, TheFarWallIsNotReportedFromOutside) {
  auto s = iso(xyz([](double, double, double z) { return z; }));
  s.max_trace = 0;
  auto o = object(s);
  o.clipped_by = {box({-9, -9, -1.5}, {9, 9, -.5})};
  EXPECT_FALSE(trace(o, {.1, .2, 5}, {0, 0, -1}));
  EXPECT_EQ(trace(o, {.1, .2, -5}, {0, 0, 1})->point.z, -1);
}

TEST(Isosurface, NaNIsInvisibleButInside) {
  const auto o = object(iso(xyz([](double, double y, double) { return std::sqrt(y); })));
  EXPECT_FALSE(trace(o, {.1, 5, .3}, {0, -1, 0}));
  EXPECT_TRUE(compile(o)->inside({0, -.5, 0}));
}

TEST(Isosurface, TinyAccuracyEnds) {
  auto s = iso(ball());
  s.accuracy = 1e-300;
  s.max_gradient = 3.6;
  const auto hit = trace(object(s), {.1, .2, -5}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, -std::sqrt(0.65), 1e-9);
}

// Fractals are known octave by octave: the same is found as with values that are computed as they are.
TEST(Isosurface, BoundsOfValuesFindWhatValuesFind) {
  using namespace functions;
  std::vector<Node> arguments{functions::test::x(), functions::test::y(), functions::test::z()};
  for (const double parameter : {0.1, 3.1, 8.0, 0.7, 0.8, 2.0}) arguments.push_back({Constant{parameter}});
  const Node fractal{UserCall{internal_function(59, 2), arguments}};
  const FunctionPtr known =
      functions::compile(functions::test::chain(functions::test::z(), Op::subtract,
                                                functions::test::times(fractal, functions::test::number(0.2))),
                         3, 3);
  ASSERT_TRUE(Narrowing::of(known.get()));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  int hits = 0;
  for (const double max_gradient : {0.3, 1.3, 4.0}) {  // too small: the picture has holes, which have to be the same
    for (const bool open : {false, true}) {
      auto s = iso(known), plain = iso(xyz([&](double x, double y, double z) { return (*known)(x, y, z); }));
      s.max_gradient = plain.max_gradient = max_gradient;
      s.open = plain.open = open;
      s.threshold = plain.threshold = 0.01;
      const auto shape = compile(object(s)), other = compile(object(plain));
      for (int i = 0; i < 3000; ++i) {
        const Vec3 from(1.5 * unit(random), 1.5 * unit(random), unit(random)),
            to(unit(random), unit(random), 0.3 * unit(random));
        const auto a = trace(*shape, from, to - from), b = trace(*other, from, to - from);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        ++hits;
        ASSERT_EQ(a->point, b->point);
        ASSERT_EQ(a->normal, b->normal);
        const Vec3 start = a->point, way(unit(random), unit(random), unit(random));
        const auto next = trace(*shape, start, way), next_other = trace(*other, start, way);
        ASSERT_EQ(next.has_value(), next_other.has_value());
        ASSERT_EQ(next ? next->point : Vec3(0), next_other ? next_other->point : Vec3(0));
      }
      EXPECT_EQ(shape->finding(), other->finding());
    }
  }
  EXPECT_GT(hits, 5000);
}

}  // namespace
}  // namespace verisim::shapes
