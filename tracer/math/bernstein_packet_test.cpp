// Eight polynomials at once have the roots that each has alone, to the last bit, with every instruction set.
#include "tracer/math/bernstein_packet.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "tracer/simd/instruction_sets.h"

namespace verisim {
namespace {

constexpr int kLanes = RootPacket::kCount;

class Polynomials {
 public:
  // Coefficients or roots at random; some of them equal, zero, huge or NaN.
  std::vector<double> any(int degree) {
    std::vector<double> c(static_cast<std::size_t>(degree) + 1);
    const int kind = number(6);
    if (kind < 2) {
      for (double& v : c) v = real_(random_);
      if (kind == 1 && degree > 1) c[static_cast<std::size_t>(number(degree))] = kStrange[number(kStrangeCount)];
      return c;
    }
    c = {real_(random_)};
    double root = 0.5;
    for (int i = 0; i < degree; ++i) {
      if (kind == 2 || number(3) > 0) root = kind == 3 ? 0.25 * number(5) : real_(random_);
      if (kind == 4) root += 1e-9;
      c.insert(c.begin(), 0);
      for (std::size_t k = 0; k + 1 < c.size(); ++k) c[k] -= root * c[k + 1];
    }
    return c;
  }
  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  double end() { return number(3) == 0 ? 0 : real_(random_); }
  double width() { return number(4) == 0 ? 1 : std::fabs(real_(random_)) * 3; }

 private:
  static constexpr int kStrangeCount = 7;
  static constexpr double kStrange[kStrangeCount] = {
      0, 0, -0.0, 1e300, 5e-324, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  std::mt19937 random_{5};
  std::normal_distribution<double> real_{0.4, 0.8};
};

TEST(BernsteinPacket, FindWhatEachPolynomialHasAlone) {
  Polynomials polynomials;
  const auto lanes = std::make_unique<RootPacket>();
  int all_roots = 0;
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const BernsteinKernels* kernels = bernstein_kernels(set);
    if (!kernels) continue;
    for (int degree = 1; degree <= kMaxBernsteinDegree; ++degree) {
      for (int round = 0; round < 400; ++round) {
        double expected[kLanes][kMaxBernsteinDegree];
        int count[kLanes];
        for (int k = 0; k < kLanes; ++k) {
          const std::vector<double> c = polynomials.any(degree);
          for (int i = 0; i <= degree; ++i) lanes->power[i][k] = c[static_cast<std::size_t>(i)];
          lanes->from[k] = polynomials.end(), lanes->to[k] = lanes->from[k] + polynomials.width();
          count[k] = bernstein_roots(degree, c.data(), lanes->from[k], lanes->to[k], expected[k], degree);
        }
        const unsigned active = round % 2 ? 255 : static_cast<unsigned>(polynomials.number(256));
        unsigned open = kernels->begin(degree, active, *lanes);
        EXPECT_EQ(open & ~active, 0u);
        for (int k = 0; k < kLanes; ++k) {
          if (active >> k & 1 & ~(open >> k)) {
            ASSERT_EQ(count[k], 0);
          }
        }
        int seen[kLanes] = {};
        for (bool first = true; open != 0; first = false) {
          // Some lanes are given up after a root, as shapes do.
          if (!first && round % 3 == 0) open &= ~(1u << polynomials.number(kLanes));
          const unsigned found = kernels->next(degree, open, *lanes);
          for (int k = 0; k < kLanes; ++k) {
            if (!(open >> k & 1)) continue;
            ASSERT_EQ(found >> k & 1, seen[k] < count[k])
                << "degree " << degree << " set " << set << " round " << round << " lane " << k;
            if (!(found >> k & 1)) continue;
            ASSERT_EQ(std::memcmp(&lanes->root[k], &expected[k][seen[k]], sizeof(double)), 0)
                << lanes->root[k] << " and " << expected[k][seen[k]] << " degree " << degree << " set " << set
                << " round " << round << " lane " << k;
            ++seen[k], ++all_roots;
          }
          open &= found;
        }
      }
    }
  }
  EXPECT_GT(all_roots, 10000);
}

}  // namespace
}  // namespace verisim
