#include "tracer/radiosity/irradiance_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

// Spec 07 2.5, a sample at a time.
double expected_weight(const IrradianceWeightQuery& query, const Vec3& delta, const Vec3& normal,
                       const Vec3& nearest_direction, double mean, double nearest) {
  const double r = std::sqrt(dot(delta, delta)), turn = std::fabs(1.0 - dot(query.normal, normal));
  const bool apart = r > 1e-6;
  const Vec3 u = apart ? delta / r : delta;
  double radius = mean;
  if (apart) {
    const double c = dot(u, nearest_direction);
    if (c > 0.0) radius = c * nearest + (1.0 - c) * mean;
    if (r >= radius * query.bound) return 0;
  }
  const double error = r / radius + 2.0 * std::sqrt(turn);
  if (!(error < query.bound)) return 0;
  const double facing = apart ? dot(u, normalize(query.normal + normal)) : 1.0;
  if (!(facing > -0.05)) return 0;  // nor where the normals are opposite
  const double t = error / query.bound;
  double weight = 1.0 - t;
  if (query.smooth) weight = t < 0.5 ? 1.0 - 2.0 * t * t : 2.0 * (1.0 - t) * (1.0 - t);
  if (facing <= 0.0) weight *= 1.0 + 20.0 * facing;
  return weight;
}

class IrradianceWeights : public testing::TestWithParam<int> {};

TEST_P(IrradianceWeights, AreThoseOfEachSample) {
  const IrradianceWeightKernels* kernels = irradiance_weight_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937 generator(3);
  std::normal_distribution<double> n(0, 1);
  std::uniform_real_distribution<double> u(0, 1);
  const auto direction = [&] { return normalize(Vec3(n(generator), n(generator), n(generator))); };
  const auto batch = std::make_unique<IrradianceBatch>();
  int counting = 0, damped = 0;
  for (int round = 0; round < 3000; ++round) {
    const IrradianceWeightQuery query{direction(), 0.3 + 2 * u(generator), round % 2 == 0};
    const int count = 1 + round % IrradianceBatch::kMax;
    Vec3 delta[IrradianceBatch::kMax], normal[IrradianceBatch::kMax], nearest_direction[IrradianceBatch::kMax];
    for (int i = 0; i < count; ++i) {
      normal[i] = i % 5 == 0 ? query.normal : normalize(query.normal + 0.7 * u(generator) * direction());
      delta[i] = i % 9 == 4 ? Vec3(i % 2 == 0 ? 0 : 1e-8) : 1.5 * u(generator) * direction();
      if (i % 4 == 1)
        delta[i] -=
            (dot(delta[i], query.normal) + 0.04 * u(generator) * length(delta[i])) * query.normal;  // a little behind
      nearest_direction[i] = i % 6 == 3 ? Vec3(0) : direction();
      batch->delta.set(i, delta[i]), batch->normal.set(i, normal[i]),
          batch->nearest_direction.set(i, nearest_direction[i]);
      batch->squared[i] = dot(delta[i], delta[i]);
      batch->mean_distance[i] = 0.1 + u(generator), batch->nearest_distance[i] = 0.05 + u(generator);
    }
    kernels->weigh(query, count, *batch);
    for (int i = 0; i < count; ++i) {
      const double expected = expected_weight(query, delta[i], normal[i], nearest_direction[i], batch->mean_distance[i],
                                              batch->nearest_distance[i]);
      ASSERT_EQ(batch->weight[i], expected) << round << ' ' << i;
      counting += expected > IrradianceBatch::kNone;
      damped += expected > 0 && i % 4 == 1;
    }
  }
  EXPECT_GT(counting, 5000);
  EXPECT_GT(damped, 1000);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, IrradianceWeights,
                         testing::Range(0, static_cast<int>(simd::kInstructionSets)));

}  // namespace
}  // namespace verisim::global
