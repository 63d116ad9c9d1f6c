#include "tracer/math/power.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace verisim::power {
namespace {

TEST(Power, LogarithmsAreThoseOfTheLibraryToTheLastBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 100000; ++i) {
    const double x = i % 2 ? std::pow(10, exponent(random)) : 1 + 1e-3 * exponent(random) / 300, expected = std::log(x);
    const double two_units = 4.5e-16 * std::fabs(expected);  // of the last place
    EXPECT_NEAR(logarithm<10>(x), expected, two_units) << x;
    EXPECT_NEAR(logarithm<11>(x), expected, two_units) << x;
  }
}

TEST(Power, ExponentialsAreThoseOfTheLibraryToTheLastBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-700, 700);
  for (int i = 0; i < 100000; ++i) {
    const double t = exponent(random) * (i % 2 ? 1 : 1e-3), expected = std::exp(t);
    EXPECT_NEAR(exponential(t) / expected, 1, 5e-16) << t;
  }
}

}  // namespace
}  // namespace verisim::power
