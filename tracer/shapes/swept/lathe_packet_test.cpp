// Eight rays and segments of a lathe: the same bits with every instruction set.
#include "tracer/shapes/packet_test_support.h"
#include "tracer/shapes/swept/lathe_packet.h"

namespace verisim::shapes::testing {
namespace {

class LatheKernel : public EachInstructionSet {};

TEST_P(LatheKernel, MeetsALatheAlike) {
  const LatheKernels *kernels = lathe_kernels(GetParam()), &plain = *lathe_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  const CurveSegment segment = CurveSegment::bezier({0.4, -1}, {1.2, -0.6}, {0.1, -0.2}, {0.3, 0.7});
  Rays rays;
  int met = 0, passed = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    LathePacket a, b;
    RootPacket roots_a, roots_b;
    const auto ask = [&](const LatheKernels& set, LathePacket& packet, RootPacket& roots) {
      packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, 255}, packet.rays);
      const unsigned near = set.begin(0.8, rays.active, packet);
      set.follow(segment, packet, roots);
      return near;
    };
    const unsigned found = ask(*kernels, a, roots_a);
    ASSERT_EQ(found, ask(plain, b, roots_b));
    each_lane(found, [&](int k) {
      EightSegments segments;
      for (int i = 0; i < 8; ++i) {
        segments.y_low[i] = 0.25 * i - 1, segments.y_high[i] = segments.y_low[i] + 0.1 * (round % 5);
        segments.low2[i] = 0.01 * i * i, segments.high2[i] = segments.low2[i] + 0.02 * (round % 7);
      }
      const double dy = a.rays.dy[k], near = round % 3 == 0 ? 0.5 : 0;
      const double y = a.rays.oy[k];
      LathePassage ray{
          std::min(y, y + 3 * dy), std::max(y, y + 3 * dy), 1e-9, a.r[k], a.m[k], a.c[k], a.rays.oy[k], near, near + 2};
      if (std::fabs(dy) > 0.1) ray.inverse = 1 / dy, ray.turn = -a.m[k] / a.r[k], ray.doubt = 1e-5;
      const unsigned along = kernels->along(segments, ray);
      ASSERT_EQ(along, plain.along(segments, ray));
      passed += 8 - std::popcount(along);
      ASSERT_TRUE(same(a.r[k], b.r[k]) && same(a.m[k], b.m[k]) && same(a.c[k], b.c[k]));
      for (int i = 0; i < 7; ++i) ASSERT_TRUE(same(roots_a.power[i][k], roots_b.power[i][k]));
      ++met;
    });
  }
  EXPECT_GT(passed, 3000);
  EXPECT_GT(8 * met - passed, 3000);
  EXPECT_GT(met, 3000);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, LatheKernel, all_instruction_sets());

}  // namespace
}  // namespace verisim::shapes::testing
