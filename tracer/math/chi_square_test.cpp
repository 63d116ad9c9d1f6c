#include "tracer/math/chi_square.h"

#include <gtest/gtest.h>

#include <utility>

namespace verisim {
namespace {

// Spec 02 section 2.3.
TEST(ChiSquare, EqualsPovRaysTableAtConfidence90) {
  const std::pair<int, double> table[] = {
      {1, 0.0170986593}, {2, 0.2107210313}, {3, 0.6020465219},   {4, 1.0636232168},   {5, 1.6433034406},
      {6, 2.2041306565}, {7, 2.8790200156}, {19, 11.7516723786}, {25, 16.5947584274}, {27, 18.1138959669}};
  for (const auto& [freedom, value] : table) EXPECT_NEAR(chi_square_quantile(freedom, 0.9), value, 2e-9) << freedom;
}

TEST(ChiSquare, FallsWithConfidence) {
  for (int freedom : {2, 5, 30}) {
    EXPECT_GT(chi_square_quantile(freedom, 0.1), chi_square_quantile(freedom, 0.9)) << freedom;
  }
}

}  // namespace
}  // namespace verisim
