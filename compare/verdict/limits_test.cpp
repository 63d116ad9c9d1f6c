#include "compare/verdict/limits.h"

#include <gtest/gtest.h>

#include "compare/metrics/test_pictures.h"

namespace verisim::compare {
namespace {

TEST(PixelLimits, SoManyPixelsMayBeWrongByAnyAmount) {
  const Picture a = constant_picture(10, 10, 100, 100, 100);
  Picture b = a;
  b.samples[0] = 1, b.samples[30] = 103 / 255.0f;
  EXPECT_EQ(pixels_beyond({0, 0, 0}, a, b), 2u);
  EXPECT_EQ(pixels_beyond({4, 0, 0}, a, b), 1u);
  EXPECT_EQ(pixels_beyond({0, 0.2, 0}, a, b), 1u);  // 103 for 100 is 7 % of the linear value
  const Metrics metrics = measure(a, b);
  EXPECT_EQ(broken_limit({{}, PixelLimits{0, 0, 2}}, metrics, a, b), "");
  EXPECT_EQ(broken_limit({{}, PixelLimits{0, 0, 1}}, metrics, a, b), "pixels_beyond 2 > 1");
  EXPECT_EQ(broken_limit({{{"max_max_abs", 10}}, {}}, metrics, a, b), "max_abs 155.0000 > 10");
}

TEST(PixelLimits, FloatsAreJudgedBeyondWhite) {
  Picture a = constant_picture(2, 1, 0, 0, 0), b = a;
  a.is_float = b.is_float = true;
  a.samples.assign(6, 50.0f), b.samples.assign(6, 50.0f);
  b.samples[3] = 51.5f;
  EXPECT_EQ(pixels_beyond({0, 0.02, 0}, a, b), 1u);
  EXPECT_EQ(pixels_beyond({0, 0.04, 0}, a, b), 0u);
}

}  // namespace
}  // namespace verisim::compare
