// Values that POV-Ray stores in binary32 must lose their low bits here, too. GCC 12 at -O2 optimises neighbouring
// roundings away unless its SLP vectoriser is off (cmake/Targets.cmake).
#include <gtest/gtest.h>

#include "tracer/math/vec.h"

namespace verisim {
namespace {

[[gnu::noinline]] Vec3 unit_in_single_precision(const Vec3& v) {
  const Vec3 n = normalize(v);
  const auto rounded = [](double x) -> double { return static_cast<float>(x); };
  return {rounded(n.x), rounded(n.y), rounded(n.z)};
}

TEST(Rounding, NeighbouringConversionsToSinglePrecisionHappen) {
  volatile double one = 1, two = -2;
  const Vec3 n = unit_in_single_precision({0, one, two});
  EXPECT_EQ(n.y, double(0.4472135901451111f));
  EXPECT_EQ(n.z, double(-0.8944271802902222f));
}

}  // namespace
}  // namespace verisim
