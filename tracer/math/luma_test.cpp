// Heights of bump maps and patterns of pictures hang on its last bit.
#include "tracer/math/luma.h"

#include <gtest/gtest.h>

namespace verisim {
namespace {

TEST(Luma, IsRoundedOnce) {
  const auto of = [](float r, float g, float b) { return luma(Color(r / 255, g / 255, b / 255)); };
  EXPECT_EQ(of(200, 17, 64), 0.30081960558891296f);
}

}  // namespace
}  // namespace verisim
