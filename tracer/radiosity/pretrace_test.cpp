#include "tracer/radiosity/pretrace.h"

#include <gtest/gtest.h>

namespace verisim::global {
namespace {

std::vector<Vec2> looked_at(PretraceTile& tile, const PretracePlan& plan, int pass, int adaptive,
                            PretraceQueries each) {
  std::vector<Vec2> positions;
  PretraceQueries so_far;
  tile.run(
      plan, pass, adaptive,
      [&](double x, double y) {
        positions.emplace_back(x, y);
        so_far.count += each.count, so_far.weight += each.weight;
      },
      [&] { return so_far; });
  return positions;
}

PretracePlan plan_of(double start, double end, int width, int height) {
  scene::Radiosity settings;
  settings.pretrace_start = start, settings.pretrace_end = end;
  return pretrace_plan(settings, width, height);
}

TEST(Pretrace, JitterEqualsProbeR1) {
  // Spec 07 P-R1: one pixel; sample at x = 0.02 * 0.5 * 0.935390, z = -0.02 * 0.5 * 0.929777.
  const PretracePlan plan = plan_of(1, 1, 1, 1);
  EXPECT_EQ(plan.passes, 1);  // floor(log2(1) + 1 - eps) + 1
  PretraceTile tile(0, {0, 0, 1, 1});
  const std::vector<Vec2> positions = looked_at(tile, plan, 0, 0, {1, 0});
  ASSERT_EQ(positions.size(), 1u);
  EXPECT_NEAR(positions[0].x, 0.5 * 0.935390, 1e-6);
  EXPECT_NEAR(positions[0].y, 0.5 * 0.929777, 1e-6);
}

TEST(Pretrace, DefaultsGiveTwoPasses) {
  const PretracePlan plan = plan_of(0.08, 0.04, 160, 120);
  EXPECT_EQ(plan.passes, 2);
  EXPECT_FLOAT_EQ(plan.spacing(0), 12.8f);
  EXPECT_FLOAT_EQ(plan.spacing(1), 6.4f);
  PretraceTile tile(1, {32, 0, 64, 32});
  EXPECT_EQ(looked_at(tile, plan, 1, 0, {1, 0}).size(), 30u);  // 32 + 5 * 6.4 is summed up to just below 64
}

TEST(Pretrace, TilesWithoutQueriesAreDoneWith) {
  const PretracePlan plan = plan_of(0.125, 0.01, 64, 64);
  PretraceTile sky(0, {0, 0, 32, 32});
  EXPECT_EQ(looked_at(sky, plan, 0, 0, {0, 0}).size(), 16u);
  EXPECT_TRUE(sky.finished());
  PretraceTile few(0, {0, 0, 16, 16});  // four positions prove nothing
  EXPECT_EQ(looked_at(few, plan, 0, 0, {0, 0}).size(), 4u);
  EXPECT_FALSE(few.finished());
}

// Probes of 3.7.0.10 by the places of its samples (error_bound 0.0001 nearest_count 5,1 pretrace_start 0.125
// pretrace_end 0.01, 64x64, +BS28 and +BS25): x of the first positions of a pass, in units of its spacing.
TEST(Pretrace, AdaptiveTilesAreCutIntoBlocks) {
  const auto columns = [](const std::vector<Vec2>& at, double spacing, std::size_t n) {
    std::vector<int> x;
    for (std::size_t i = 0; i < n; ++i)
      x.push_back(static_cast<int>(std::lround((at[i].x - (spacing - 1) / 2) / spacing)));
    return x;
  };
  const PretracePlan plan = plan_of(0.125, 0.01, 64, 64);
  PretraceTile tile(0, {0, 0, 28, 28});
  looked_at(tile, plan, 0, 1, {1, 0}), looked_at(tile, plan, 1, 1, {1, 0});
  const std::vector<Vec2> third = looked_at(tile, plan, 2, 1, {1, 0});
  EXPECT_EQ(third.size(), 196u);
  EXPECT_EQ(columns(third, 2, 30), (std::vector<int>{0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4,
                                                     0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  const std::vector<Vec2> fourth = looked_at(tile, plan, 3, 1, {1, 0});
  EXPECT_EQ(fourth.size(), 784u);
  EXPECT_EQ(columns({fourth.begin() + 100, fourth.end()}, 1, 8), (std::vector<int>{10, 11, 12, 13, 10, 11, 12, 13}));

  const PretracePlan fractional = plan_of(0.1, 0.01, 64, 64);  // 25 / 3.2 < 8, but there are eight positions
  PretraceTile wide(0, {0, 0, 25, 25});
  looked_at(wide, fractional, 0, 1, {1, 0});
  EXPECT_EQ(columns(looked_at(wide, fractional, 1, 1, {1, 0}), 3.2, 6), (std::vector<int>{0, 1, 2, 3, 0, 1}));
}

TEST(Pretrace, BlocksThatFoundEnoughTakeNoJitter) {
  const PretracePlan plan = plan_of(0.125, 0.01, 64, 64);
  PretraceTile tile(0, {0, 0, 32, 32}), other(0, {0, 0, 32, 32});
  for (PretraceTile* t : {&tile, &other}) looked_at(*t, plan, 0, 4, {1, 0});
  const std::vector<Vec2> all = looked_at(other, plan, 1, 4, {1, 0});
  PretraceQueries so_far;
  tile.run(
      plan, 1, 4, [&](double x, double y) { ++so_far.count, so_far.weight += x < 15.5 && y < 15.5 ? 5 : 0; },
      [&] { return so_far; });
  const std::vector<Vec2> left = looked_at(tile, plan, 2, 4, {1, 0}), rest = looked_at(other, plan, 2, 4, {1, 0});
  ASSERT_EQ(left.size(), 192u);
  ASSERT_EQ(rest.size(), 256u);
  EXPECT_NEAR(left[0].x - 16, rest[0].x, 1e-12);
  EXPECT_NEAR(left[0].y, rest[0].y, 1e-12);
}

}  // namespace
}  // namespace verisim::global
