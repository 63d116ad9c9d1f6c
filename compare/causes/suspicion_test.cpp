#include "compare/causes/suspicion.h"

#include <gtest/gtest.h>

namespace verisim::compare {
namespace {

TEST(PixelRuns, HoldAMask) {
  for (const std::vector<unsigned char>& mask : std::vector<std::vector<unsigned char>>{
           {}, {0, 0, 0}, {1, 1}, {0, 1, 1, 0}, {1, 0, 0, 1}, {0, 0, 1, 0, 1, 1, 0, 0, 0, 0}})
    EXPECT_EQ(mask_of(runs_of(mask), mask.size()), mask);
  EXPECT_EQ(runs_of({0, 0, 1, 1, 1, 0}), (PixelRuns{2, 3}));
  EXPECT_EQ(runs_of({1, 1, 0, 1}), (PixelRuns{0, 2, 1, 1}));
}

TEST(PixelRuns, ThatReachTooFarAreCut) { EXPECT_EQ(mask_of({1, 100}, 3), (std::vector<unsigned char>{0, 1, 1})); }

}  // namespace
}  // namespace verisim::compare
