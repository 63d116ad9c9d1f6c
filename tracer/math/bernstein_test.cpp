#include "tracer/math/bernstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace verisim {
namespace {

std::vector<double> roots_of(const std::vector<double>& power, double a, double b) {
  const int degree = static_cast<int>(power.size()) - 1;
  double roots[kMaxBernsteinDegree];
  const int n = bernstein_roots(degree, power.data(), a, b, roots);
  std::vector<double> result;
  for (int i = 0; i < n; ++i) result.push_back(roots[i]);
  return result;
}

std::vector<double> rising_from_roots(const std::vector<double>& roots) {
  std::vector<double> c{1};
  for (const double r : roots) {
    c.insert(c.begin(), 0);
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] -= r * c[i + 1];
  }
  return c;
}

TEST(Bernstein, FindsTheRootsOfAnIntervalInOrder) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> position(-3, 3);
  for (int degree = 1; degree <= 10; ++degree) {
    for (int trial = 0; trial < 300; ++trial) {
      std::vector<double> roots;
      for (int i = 0; i < degree; ++i) roots.push_back(position(random));
      std::sort(roots.begin(), roots.end());
      bool apart = true;
      for (int i = 1; i < degree; ++i) apart = apart && roots[i] - roots[i - 1] > 0.05;
      std::vector<double> expected;
      for (const double r : roots) {
        if (r > -1 && r < 2) expected.push_back(r);
        apart = apart && std::fabs(r + 1) > 0.01 && std::fabs(r - 2) > 0.01;
      }
      if (!apart) continue;
      const auto found = roots_of(rising_from_roots(roots), -1, 2);
      ASSERT_EQ(found.size(), expected.size()) << "degree " << degree;
      for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-6);
    }
  }
}

TEST(Bernstein, ClosePairsAreKeptApart) {
  const auto found = roots_of(rising_from_roots({0.5, 0.5 + 1e-6}), 0, 1);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 0.5, 1e-9);
}

TEST(Bernstein, AnEndThatIsNearlyARootDoesNotHideTheOther) {
  // 1.1e-16, 0.507, 0.761, -0.6, -0.6 in Bernstein form.
  const auto found =
      roots_of({1.1102230246251565e-16, 2.0265392748282255, -1.5154310158189, -6.7096, 5.5984917410}, 0, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0], 0.4);
}

TEST(Bernstein, RootsAtTheEnds) {
  EXPECT_EQ(roots_of({0, 1}, 0, 1), std::vector<double>{0});
  EXPECT_EQ(roots_of({-1, 1}, 0, 1), std::vector<double>{1});
}

}  // namespace
}  // namespace verisim
