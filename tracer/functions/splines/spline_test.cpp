// Probe P19 of spec 01.
#include "tracer/functions/splines/spline.h"

#include <gtest/gtest.h>

namespace verisim {
namespace {

Spline four_points() {
  Spline s;
  s.insert(0, {0, 0, 1}, 3), s.insert(1, {1, 2, 3}, 3), s.insert(2, {3, 1, 0}, 3), s.insert(4, {0, 5, 2}, 3);
  return s;
}

void expect(const Spline& s, Spline::Kind kind, double t, std::array<double, 3> expected) {
  const auto v = s.evaluate(t, kind);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(v[k], expected[k], 1e-14) << "t = " << t << " component " << k;
}

TEST(Splines, FourPoints) {
  using enum Spline::Kind;
  const Spline s = four_points();
  expect(s, linear, .5, {.5, 1, 2}), expect(s, linear, 1.7, {2.4, 1.3, .9}), expect(s, linear, 2.5, {2.25, 2, .5});
  expect(s, quadratic, .5, {.375, 1.375, 2.625}), expect(s, quadratic, 1.7, {2.295, 1.615, 1.425}),
      expect(s, quadratic, 2.5, {3.125, 1.25, -.5});
  expect(s, cubic, .5, {1, 2, 3}), expect(s, cubic, 1.7, {2.62575, 1.174, .7635}), expect(s, cubic, 2.5, {3, 1, 0});
  expect(s, cubic, 1.5, {2.15625, 1.5, 1.5625});
  expect(s, natural, .5, {0.345108695652174, 1.342391304347826, 2.554347826086957});
  expect(s, natural, 1.7, {2.520065217391304, 1.316434782608696, 0.977608695652174});
  expect(s, natural, 2.5, {3.105978260869565, 1.144021739130435, -0.698369565217391});
  for (const auto kind : {linear, quadratic, natural}) {
    expect(s, kind, -1, {0, 0, 1});
    expect(s, kind, 9, {0, 5, 2});
  }
}

// Printed by POV-Ray with all digits.
TEST(Splines, LastDigitsOfCubicSplines) {
  const auto value = [](std::array<double, 4> t, std::array<double, 4> v, double at) {
    Spline s;
    for (std::size_t i = 0; i < 4; ++i) s.insert(t[i], {v[i]}, 1);
    return s.evaluate(at, Spline::Kind::cubic)[0];
  };
  EXPECT_EQ(value({-3.762, -2.768, -0.755, 3.269}, {2.549, 8.954, 1.542, -2.066}, -2.185017), 8.129896396119403);
  EXPECT_EQ(value({-1.859, -0.724, 0.856, 1.804}, {-0.936, -4.005, 5.888, 3.98}, 0.183589), 1.858798337120114);
  EXPECT_EQ(value({-1.863, 0.944, 1.953, 3.755}, {1.598, -0.876, 6.799, 8.894}, 1.422365), 2.5855018214121954);
  EXPECT_EQ(value({-1.863, 0.944, 1.953, 3.755}, {1.598, -0.876, 6.799, 8.894}, 1.61413), 4.382191321084943);
}

TEST(Splines, RepeatedParameters) {
  Spline last;
  last.insert(0, {0, 0, 0}, 3), last.insert(1, {1, 1, 1}, 3), last.insert(1, {5, 5, 5}, 3);
  expect(last, Spline::Kind::linear, 2, {1, 1, 1});
  Spline middle;
  middle.insert(2, {3, 1, 0}, 3), middle.insert(0, {0, 0, 1}, 3), middle.insert(1, {1, 2, 3}, 3),
      middle.insert(1, {9, 9, 9}, 3);
  expect(middle, Spline::Kind::linear, 1.5, {6, 5, 4.5});
}

TEST(Splines, MissingComponentsKeepThePreviousPoints) {
  Spline s;
  s.insert(0, {1, 2, 3, 4, 5}, 5), s.insert(1, {1, 2}, 2);
  EXPECT_EQ(s.terms(), 5);
  EXPECT_EQ(s.evaluate(.5), (Spline::Value{1, 2, 3, 4, 5}));
}

TEST(Splines, FewPoints) {
  Spline s;
  EXPECT_TRUE(s.empty());
  EXPECT_EQ(s.evaluate(1), Spline::Value{});
  s.insert(1, {1, 2}, 2);
  EXPECT_EQ(s.evaluate(7)[1], 2);
  s.insert(3, {3, 4}, 2);
  for (const auto kind : {Spline::Kind::linear, Spline::Kind::quadratic, Spline::Kind::natural})
    EXPECT_EQ(s.evaluate(2, kind)[0], 2);
  EXPECT_EQ(s.evaluate(0, Spline::Kind::cubic)[0], 2);  // the mean, everywhere
}

}  // namespace
}  // namespace verisim
