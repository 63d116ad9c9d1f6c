// Eight rays on their way to a superellipsoid: the same bits with every instruction set.
#include "tracer/shapes/algebraic/superellipsoid_packet.h"
#include "tracer/shapes/packet_test_support.h"

#include <random>

namespace verisim::shapes::testing {
namespace {

class SuperellipsoidKernel : public EachInstructionSet {};

TEST_P(SuperellipsoidKernel, ApproachesASuperellipsoidInTheSameSteps) {
  const SuperellipsoidKernels *kernels = superellipsoid_kernels(GetParam()),
                              &plain = *superellipsoid_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  Rays rays;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    const double p = 1 + round % 14, q = 1 + round % 5 * 0.7;
    ConvexPacket a{};
    for (int k = 0; k < kLanes; ++k) {
      const Ray ray = rays.batches->at(k);
      a.ox[k] = ray.origin.x, a.oy[k] = ray.origin.y, a.oz[k] = ray.origin.z, a.dx[k] = ray.direction.x,
      a.dy[k] = ray.direction.y, a.dz[k] = ray.direction.z;
      a.t[k] = 0, a.end[k] = 20, a.side[k] = 1;
    }
    ConvexPacket b = a, alone = a, pair = a;
    const unsigned found = kernels->approach(p, q, rays.active, a);
    ASSERT_EQ(found, plain.approach(p, q, rays.active, b));
    const double* values = a.value;
    each_lane(found, [&](int k) {
      ASSERT_TRUE(same(a.t[k], b.t[k]));
      ASSERT_TRUE(same(values[k], b.value[k]));
      ++met;
      // The value is that of the plain formula, and zero at the root of rays that begin outside.
      const Vec3 at(std::fabs(a.ox[k] + a.t[k] * a.dx[k]), std::fabs(a.oy[k] + a.t[k] * a.dy[k]),
                    std::fabs(a.oz[k] + a.t[k] * a.dz[k]));
      const double largest = std::max(at.x, at.y);
      if (round % 3 == 0 || !(largest > 0)) return;
      const double across = largest * std::pow(std::pow(at.x / largest, p) + std::pow(at.y / largest, p), 1 / p),
                   most = std::max(across, at.z);
      const double expected = most * std::pow(std::pow(across / most, q) + std::pow(at.z / most, q), 1 / q) - 1;
      ASSERT_NEAR(values[k], expected, 1e-13 * (1 + std::fabs(expected))) << p << ' ' << q;
      if (a.t[k] > 0) {
        ASSERT_NEAR(expected, 0, 3e-10);
      }
    });
    // What one lane finds does not depend on the others.
    const int k = round % kLanes;
    const unsigned found_alone = kernels->approach(p, q, 1u << k, alone);
    if (rays.active >> k & 1) {
      ASSERT_EQ(found_alone, found & 1u << k);
    }
    if (found >> k & 1) {
      ASSERT_TRUE(same(alone.t[k], a.t[k]));
    }
    const unsigned found_pair = kernels->approach_pair(p, q, rays.active & 3, pair);
    ASSERT_EQ(found_pair, found & 3);
    each_lane(found_pair,
              [&](int lane) { ASSERT_TRUE(same(pair.t[lane], a.t[lane]) && same(pair.value[lane], a.value[lane])); });
  }
  EXPECT_GT(met, 5000);
}

TEST_P(SuperellipsoidKernel, NormsHaveTheBitsOfThePlainFormula) {
  const SuperellipsoidKernels* kernels = superellipsoid_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double exponents[] = {0.02, 0.1, 0.25, 1.0 / 3, 0.5, 0.7, 1, 1.3, 2, 3.7};
  for (int round = 0; round < 20000; ++round) {
    const EllipsoidNorm across(exponents[round % 10]), all(exponents[round / 10 % 10]);
    EllipsoidPoints points;
    double norms[EllipsoidPoints::kCount];
    for (int k = 0; k < EllipsoidPoints::kCount; ++k) {
      const double small = round % 7 == 0 ? std::exp2(30 * unit(random) - 30) : 1;
      points.x[k] = unit(random), points.y[k] = small * unit(random), points.z[k] = 1.2 * unit(random);
      if (round % 5 == 0) (k % 3 == 0 ? points.x : k % 3 == 1 ? points.y : points.z)[k] = 0;
      if (round % 11 == 0) points.y[k] = -points.x[k];
    }
    const unsigned active = round % 2 == 0 ? 255u : static_cast<unsigned>(round) * 37 & 255u;
    kernels->norms(across, all, active, points, norms);
    each_lane(active, [&](int k) {
      const double expected = all(across(std::fabs(points.x[k]), std::fabs(points.y[k])), std::fabs(points.z[k]));
      ASSERT_TRUE(same(norms[k], expected)) << points.x[k] << ' ' << points.y[k] << ' ' << points.z[k];
    });
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, SuperellipsoidKernel, all_instruction_sets());

}  // namespace
}  // namespace verisim::shapes::testing
