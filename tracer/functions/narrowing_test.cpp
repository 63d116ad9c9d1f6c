#include "tracer/functions/narrowing.h"

#include <random>

#include <gtest/gtest.h>

#include "tracer/functions/internal/formula_table.h"
#include "tracer/functions/test_support.h"

namespace verisim::functions {
namespace {

using namespace test;

struct Ridged {
  double H, lacunarity, octaves, offset, gain, generator;
};
// A function of its own each time: the first call sets the weights of the octaves.
Node ridged(const Ridged& r, Node at_x = x()) {
  return {UserCall{internal_function(59, 2),
                   {std::move(at_x), y(), z(), number(r.H), number(r.lacunarity), number(r.octaves), number(r.offset),
                    number(r.gain), number(r.generator)}}};
}
Node minus(Node a, Node b) { return chain(std::move(a), Op::subtract, std::move(b)); }

// Bounds that are not farther apart than `tolerance`, where the value is a number.
Bounds closer(const Narrowing& narrowing, const Vec3& p, double tolerance, Narrowing::Workspace& workspace) {
  Narrowing::Value value;
  narrowing.begin(p, value, workspace);
  while (!(value.bounds.high - value.bounds.low <= tolerance) && narrowing.narrow(value, workspace)) {
  }
  return value.bounds;
}

const Ridged kUsual{0.1, 3.1, 8, 0.7, 0.8, 2};
const Ridged kAll[] = {kUsual,
                       {0.07, 2.2, 7, 0.6, 0.9, 1},
                       {1, 2, 3.5, 1, 2, 3},
                       {0.5, 0.4, 8, -0.5, 6, 2},
                       {0.1, 2, 1, 0.7, 0.8, 2},
                       {0.1, 2, 12, 0.7, 0.8, 2},
                       {0.1, 2, 6, 0.7, -0.8, 2},
                       {2, -2, 6, 0.7, 3, 2},
                       {-0.4, 2, 6, 1e3, 1e3, 1}};

TEST(Narrowing, BoundsHoldTheValueAndComeAsCloseAsIsAsked) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int before_all_octaves = 0;
  for (const Ridged& r : kAll) {
    const std::vector<Node> expressions{ridged(r),
                                        minus(z(), times(ridged(r), number(0.07))),
                                        minus(ridged(r), y()),
                                        of(Builtin::max_, {minus(z(), ridged(r)), times(x(), y())}),
                                        of(Builtin::min_, {times(y(), ridged(r)), z()}),
                                        chain(ridged(r, times(number(3), of(Builtin::sin_, {x()}))), Op::divide, y())};
    for (const Node& expression : expressions) {
      const FunctionPtr f = compile(expression, 3, 3);
      const auto narrowing = Narrowing::of(f.get());
      ASSERT_TRUE(narrowing);
      Narrowing::Workspace workspace(*narrowing);
      for (int i = 0; i < 2000; ++i) {
        const double size = i % 100 == 0 ? 1e8 : i % 7 == 0 ? 1000 : 3;
        const Vec3 p(size * unit(random), size * unit(random), size * unit(random));
        const double value = (*f)(p.x, p.y, p.z), tolerance = std::pow(10.0, -3 + 3 * unit(random));
        const Bounds bounds = closer(*narrowing, p, tolerance, workspace);
        ASSERT_LE(bounds.low, value);
        ASSERT_GE(bounds.high, value);
        ASSERT_LE(bounds.high - bounds.low, tolerance);
        before_all_octaves += bounds.low < bounds.high;
        const Bounds known = closer(*narrowing, p, 0, workspace);
        ASSERT_EQ(known.low, value);
        ASSERT_EQ(known.high, value);
      }
    }
  }
  EXPECT_GT(before_all_octaves, 10000);
}

TEST(Narrowing, SurvivesWhatIsNotANumber) {
  const FunctionPtr f = compile(minus(of(Builtin::sqrt_, {z()}), ridged(kUsual)), 3, 3);
  const auto narrowing = Narrowing::of(f.get());
  ASSERT_TRUE(narrowing);
  Narrowing::Workspace workspace(*narrowing);
  EXPECT_FALSE(closer(*narrowing, {0.1, 0.2, -1}, 0, workspace).low <= 0);
  closer(*narrowing, Vec3(std::numeric_limits<double>::quiet_NaN()), 0, workspace);
  closer(*narrowing, Vec3(std::numeric_limits<double>::infinity()), 0, workspace);
}

TEST(Narrowing, IsOnlyOfFunctionsThatRiseOrFallWithOneSum) {
  const auto suits = [](const Node& expression) {
    const FunctionPtr f = compile(expression, 3, 3);
    return Narrowing::of(f.get()) != nullptr;
  };
  EXPECT_TRUE(suits(ridged(kUsual)));
  EXPECT_FALSE(suits(plus(x(), y())));
  Node with_parameter = ridged(kUsual);
  std::get<UserCall>(with_parameter.value).arguments[5] = x();
  EXPECT_FALSE(suits(with_parameter));
  EXPECT_FALSE(suits(plus(ridged(kUsual), ridged(kUsual))));
  EXPECT_FALSE(suits(of(Builtin::abs_, {ridged(kUsual)})));
  EXPECT_FALSE(suits(of(Builtin::sin_, {ridged(kUsual)})));
  EXPECT_FALSE(suits(chain(x(), Op::divide, ridged(kUsual))));
  const FunctionPtr other = internal_function(59, 2);
  EXPECT_FALSE(Narrowing::of(other.get()));
}

}  // namespace
}  // namespace verisim::functions
