#include "tracer/textures/patterns/tilings/tiling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace verisim::textures {
namespace {

double tiling(int number, double x, double z) {
  const Tiling* periodic = periodic_tiling(number);
  return periodic ? evaluate_tiling(*periodic, x, z) : penrose_tiling(number, x, z);
}

// Probe P5 of spec 05: values of POV-Ray at five points, printed from single precision.
TEST(Tiling, EqualsPovRay) {
  const double points[5][2] = {{0.3, 0.7}, {2.4, -1.9}, {-5.2, 3.3}, {7.7, 6.1}, {-2.9, -8.4}};
  const double expected[27][5] = {
      {0.4, 0.8, 0.6, 0.8, 0.8},
      {0.2958548, 0.4969655, 0.8105118, 0.9563267, 0.7497423},
      {0.8437822, 0.7091035, 0.8421162, 0.4344901, 0.9246134},
      {0.7917096, 0.612138, 0.7894882, 0.9126534, 0.8994845},
      {0.5972365, 0.204046, 0.8736745, 0.3042178, 0.6331615},
      {0.7, 0.9, 0.8, 0.4, 0.1},
      {0.5, 0.5, 0.6819805, 0.9355339, 0.9547727},
      {0.6666667, 0.6274362, 0.2838887, 0.7690599, 0.9193177},
      {0.6666667, 0.806069, 0.5614108, 0.6666667, 0.7497423},
      {0.4, 0.8, 0.4, 0.8, 0.2},
      {0.8, 0.9333333, 0.8666667, 0.6, 0.9333333},
      {0.8, 0.7333333, 0.4666667, 0.6, 0.9333333},
      {0.7333333, 0.7372583, 0.9901876, 0.4385763, 0.990861},
      {0.24, 0.04235498, 0.3941126, 0.4631458, 0.1945166},
      {0.2, 0.6, 0.7, 0.4, 0.4},
      {0, 0, 0.8599564, 0.2020956, 0.2941028},
      {0.1666668, 0.3333335, 0.9299782, 0.4343813, 0.1470514},
      {0.7, 0.9, 0.8, 0.9, 0.1},
      {0.5625215, 0.4727356, 0.5614108, 0.28966, 0.6164089},
      {0.5625215, 0.806069, 0.5614108, 0.28966, 0.6164089},
      {0.7410684, 0.9298294, 0.7231191, 0.8333335, 0.4030345},
      {0.2488034, 0.6666667, 0.6666667, 0.6666667, 0.6666667},
      {0.2, 0.3106836, 0.292179, 0.31547, 0.1322226},
      {0.12, 0.1864102, 0.1753074, 0.189282, 0.07933358},
      {0.4598373, 0.06778449, 0.604243, 0.6413603, 0.6228095},
      {0.03524783, 0.1508677, 0.270305, 0.05488705, 0.2516472},
      {0.3816533, 0.23149, 0.3233466, 0.777987, 0.8089973},
  };
  for (int n = 1; n <= 27; ++n)
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(tiling(n, points[k][0], points[k][1]), expected[n - 1][k], 3e-7)
          << "tiling " << n << " at point " << k;
}

// Whose borders are, and whole x in tiling 3, on quarter coordinates: POV-Ray's values, printed from single precision.
TEST(Tiling, BordersBelongToTheTileThatPovRayTakes) {
  struct Probe {
    int number;
    double x, z, value;
  };
  const Probe probes[] = {
      {3, 0.25, 0, 0.5},     {5, 0.25, 0, 0.333333}, {5, -0.5, 0, 1},        {5, -3, 0, 0.666667},     {6, 0.25, 0, 1},
      {6, 0, -0.5, 0.5},     {9, 0.25, 0, 1},        {9, -0.5, 0, 0.333333}, {11, 0, -0.25, 0.666667}, {11, 0, 0.25, 1},
      {11, 1, 1, 0.333333},  {15, 0.25, 0, 0.5},     {15, -1, 0, 1},         {18, 0, -0.25, 0.5},      {18, 0, 0.25, 1},
      {3, -2, -2, 0.767949}, {3, 1, 0.75, 0.299038}, {3, 1, -0.5, 0.566987}};
  for (const Probe& p : probes)
    EXPECT_NEAR(tiling(p.number, p.x, p.z), p.value, 1e-6) << p.number << " at " << p.x << ", " << p.z;
  EXPECT_NEAR(tiling(18, -2.3e-16, 0.5), tiling(18, -1e-9, 0.5), 1e-6);
}

// POV-Ray's values (those above 1 from what maps make of them) just below 0, where folding by the period rounds up.
TEST(Tiling, WhatLiesHardlyBelowZeroIsFoldedToThePeriod) {
  struct Probe {
    int number;
    double x, z, value;
  };
  const double e = -1e-17;
  const Probe probes[] = {{6, 1.3, -2.2e-16, 4},
                          {6, e, 0.3, 4},
                          {6, e, 1, 3.5},
                          {6, e, -1.97, 2.5},
                          {6, e, e, 4},
                          {18, 1.3, e, 4},
                          {18, -2.2e-16, 1.5, 2.5},
                          {18, e, 3, 4},
                          {11, 0.2, e, 7 / 3.0},
                          {11, e, 1.2, 4 / 3.0},
                          {11, e, 2, 7 / 3.0},
                          {15, 0.3, -4.4e-16, 5},
                          {15, e, 0.3, 4},
                          {15, e, -1, 5},
                          {15, e, 2, 5},
                          {3, e, -3.97, 0.56188},
                          {3, -1e-16, -3.97, 0.06188},
                          {8, 0.3, e, 2 / 3.0},
                          {5, 0.28, e, 1},
                          {5, -3.345, e, 1 / 3.0},
                          {13, -2.2e-16, 1.28, 1},
                          {13, 7e-17, 0.3, 0},
                          {13, 8.1e-17, 0.3, 1},
                          {3, 1, 0, 0.5},
                          {3, 1, e, 1},
                          {14, 0.3, -2.2e-16, 0.8},
                          {19, 0.25, e, 1 / 3.0},
                          {19, 1.5, e, 2 / 3.0},
                          {19, 3.5, -2.2e-16, 1 / 3.0},
                          {19, 0.75, 5e-17, 1 / 3.0},
                          {20, 0.5, e, 2 / 3.0},
                          {20, 5.5, e, 1 / 3.0}};
  for (const Probe& p : probes)
    EXPECT_NEAR(tiling(p.number, p.x, p.z), p.value, 1e-5) << p.number << " at " << p.x << ", " << p.z;
}

// POV-Ray's values on z = 0 at every quarter of a period, in twelfths.
TEST(Tiling, LevelLineLeansEitherWay) {
  const int twelfths[2][28] = {
      {8, 4, 4, 4, 8, 4, 4, 4, 8, 4, 4, 8, 12, 12, 12, 12, 4, 8, 8, 8, 4, 9, 8, 8, 8, 8, 8, 9},
      {8, 4, 4, 4, 8, 4, 4, 4, 8, 9, 8, 8, 8, 8, 8, 9, 12, 8, 8, 8, 4, 8, 8, 8, 4, 8, 8, 8},
  };
  for (const int n : {19, 20})
    for (const double start : {-14.0, 0.0, 7.0})
      for (int k = 0; k < 28; ++k)
        EXPECT_NEAR(tiling(n, start + k / 4.0, 0), twelfths[n - 19][k] / 12.0, 1e-5) << n << " at " << start + k / 4.0;
}

TEST(Tiling, TilesCoverThePlane) {
  // In every tiling a fine walk meets values from the edge (top of a class) down to the flat part, and never leaves (0,
  // 1].
  for (int n = 1; n <= 27; ++n) {
    double lowest = 2, highest = -1;
    for (int i = 0; i < 4000; ++i) {
      const double v = tiling(n, 0.00731 * i - 13, 0.00917 * i - 7);
      lowest = std::min(lowest, v);
      highest = std::max(highest, v);
    }
    EXPECT_GE(lowest, 0) << n;
    EXPECT_LE(highest, 1.0 + 1e-6) << n;
    EXPECT_GT(highest - lowest, 0.4) << n;
  }
}

TEST(Tiling, SurvivesFarAndInvalidPoints) {
  for (int n = 1; n <= 27; ++n)
    for (const double x :
         {1e17, -1e17, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      tiling(n, x, 1);
}

// Measured by #write on the lines between cells.
TEST(Tiling, HasNoTilesOnSeamsOfSome) {
  const auto shown = [](int n, double x, double z) { return std::fmod(tiling(n, x, z), 1.00001); };  // by a map
  EXPECT_NEAR(shown(12, 1.3, 0), 0.33331335, 3e-8);
  EXPECT_NEAR(shown(12, 0, 2.7733), 0.33331335, 3e-8);
  EXPECT_NEAR(shown(12, 0, -1.7315), 0.33332333, 3e-8);
  EXPECT_EQ(tiling(13, -4.7, 0), 0);
  EXPECT_EQ(tiling(14, 2.5, 0), 0);
  EXPECT_EQ(tiling(14, 0, 2.3678), 0);
  EXPECT_NEAR(shown(13, -1e-16, 1.3), 0.22564176, 1e-7);
  EXPECT_NEAR(tiling(14, -1e-16, 1.3), 0.93539107, 1e-7);
  EXPECT_NEAR(tiling(13, 0, 2.0388), 0.744469, 1e-4);
  EXPECT_NEAR(tiling(14, 0, 2.0388), 0.846682, 1e-4);
}

}  // namespace
}  // namespace verisim::textures
