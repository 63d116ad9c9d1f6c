#include "tracer/radiosity/irradiance_packet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

class IrradianceNear : public testing::TestWithParam<int> {};

TEST_P(IrradianceNear, FindTheSamplesThatReach) {
  const IrradianceKernels* kernels = irradiance_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  constexpr double kUnit = 2.0 / 32767;
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vec3(u(generator), u(generator), u(generator)); };
  int reaching = 0, found_in_vain = 0, others = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<IrradiancePacket> blocks(static_cast<std::size_t>(1 + round % 9));
    const Vec3 axis = normalize(vector());
    const IrradianceQuery query{vector(), normalize(axis + 0.2 * vector()), 0.3 + std::fabs(u(generator)), kUnit};
    std::vector<std::uint32_t> expected, all;
    const bool doubled = round % 2 == 0;
    const std::size_t count = blocks.size() * IrradiancePacket::kCount - static_cast<std::size_t>(round) % 8;
    std::uint32_t number = 0;
    for (IrradiancePacket& block : blocks) {
      for (std::uint32_t i = 0; i < IrradiancePacket::kCount; ++i) {
        const Vec3 p = vector(), n = normalize(axis + 0.5 * vector());
        const float mean = static_cast<float>(std::fabs(u(generator))) * 3;
        const float widest = mean + static_cast<float>(std::fabs(u(generator)));
        block.set(i, {p / (doubled ? kUnit / 2 : kUnit), n, mean, widest, ++number * 7});
        if (number > count) continue;  // unused
        const double r = length(p - query.point), turn = std::max(0.0, 1 - dot(n, query.normal));
        all.push_back(number * 7);
        if (r < query.bound * mean && r / widest + 2 * std::sqrt(turn) < query.bound) expected.push_back(number * 7);
      }
    }
    for (IrradiancePacket& block : blocks) {
      if (doubled) block.double_unit();
    }
    std::vector<std::uint32_t> found(all.size());
    found.resize(kernels->near(blocks.data(), all.size(), query, found.data()));
    ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
    ASSERT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    reaching += static_cast<int>(expected.size()), found_in_vain += static_cast<int>(found.size() - expected.size()),
        others += static_cast<int>(all.size() - expected.size());
  }
  EXPECT_GT(reaching, 500);
  EXPECT_LT(found_in_vain, others / 500);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, IrradianceNear, testing::Range(0, static_cast<int>(simd::kInstructionSets)));

}  // namespace
}  // namespace verisim::global
