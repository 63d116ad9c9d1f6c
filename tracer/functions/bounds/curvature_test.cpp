#include "tracer/functions/bounds/curvature.h"

#include <random>

#include <gtest/gtest.h>

#include "tracer/functions/bounds/interval.h"
#include "tracer/functions/test_support.h"

namespace verisim::functions {
namespace {

using namespace test;

Node distance() { return of(Builtin::sqrt_, {plus(plus(times(x(), x()), times(y(), y())), times(z(), z()))}); }

const Program& program(const FunctionPtr& f) { return dynamic_cast<const Program&>(*f); }
double bend(const Node& expression, const Box3& box) {
  const FunctionPtr f = compile(expression, 3, 3);
  return CurvatureBounds(program(f), 1e-13).within(box).bend;
}
const Box3 kUnit{Vec3(-1), Vec3(1)};

TEST(Curvature, IsThatOfSimpleFunctions) {
  EXPECT_NEAR(bend(times(x(), x()), kUnit), 2, 1e-6);
  EXPECT_NEAR(bend(times(x(), y()), kUnit), 1, 1e-6);
  EXPECT_NEAR(bend(plus(x(), times(number(3), z())), kUnit), 0, 1e-6);
  EXPECT_NEAR(bend(of(Builtin::sin_, {times(number(5), y())}), kUnit), 25, 1e-6);
  EXPECT_NEAR(bend(of(Builtin::exp_, {z()}), kUnit), std::exp(1), 1e-6);
}

TEST(Curvature, IsUnknownAtEdges) {
  const Box3 aside{Vec3(0.5), Vec3(0.7)};
  for (const Node& f :
       {of(Builtin::abs_, {x()}), of(Builtin::sqrt_, {x()}), of(Builtin::ln_, {x()}),
        of(Builtin::max_, {x(), number(0)}), chain(y(), Op::divide, x()), of(Builtin::pow_, {x(), number(0.5)}),
        of(Builtin::tan_, {times(number(2), x())}), of(Builtin::select_, {x(), y(), z(), number(1)}),
        of(Builtin::atan2_, {x(), times(y(), z())})}) {
    EXPECT_TRUE(std::isinf(bend(f, kUnit)));
    EXPECT_FALSE(std::isinf(bend(f, aside)));
  }
  EXPECT_TRUE(std::isinf(bend(of(Builtin::floor_, {x()}), aside)));
}

// Second differences of the function, along any direction, are never larger.
TEST(Curvature, HoldsSecondDifferences) {
  const Node angle = of(Builtin::atan2_, {x(), z()}),
             waves = times(of(Builtin::sin_, {times(number(6), x())}), of(Builtin::cos_, {times(number(4), y())}));
  const std::vector<Node> expressions{plus(distance(), times(number(0.2), waves)),
                                      plus(times(y(), y()), of(Builtin::cos_, {times(number(8), angle)})),
                                      chain(waves, Op::divide, plus(number(1.5), z())),
                                      of(Builtin::exp_, {times(waves, z())}),
                                      of(Builtin::ln_, {plus(number(0.1), distance())}),
                                      of(Builtin::pow_, {distance(), number(-1.5)}),
                                      of(Builtin::abs_, {plus(waves, x())}),
                                      of(Builtin::min_, {distance(), plus(waves, number(0.9))}),
                                      of(Builtin::atan_, {times(number(3), waves)}),
                                      of(Builtin::tan_, {times(x(), y())}),
                                      of(Builtin::select_, {plus(x(), times(y(), z())), waves, distance(), angle}),
                                      of(Builtin::log_, {plus(times(x(), x()), times(z(), z()))})};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (const Node& expression : expressions) {
    const FunctionPtr f = compile(expression, 3, 3);
    CurvatureBounds bounds(program(f), 1e-13);
    int known = 0;
    double closest = 0;
    for (int n = 0; n < 2000; ++n) {
      const Vec3 corner = point();
      const double size = 0.03 + 0.1 * std::fabs(unit(random));
      const Box3 box(corner, corner + Vec3(size));
      const Curvature c = bounds.within(box);
      if (std::isinf(c.bend)) continue;
      ++known;
      for (int k = 0; k < 10; ++k) {
        const Vec3 middle = corner + (Vec3(1) + point()) * (size / 2), toward = normalize(point());
        double step = 1e-3;
        for (int i = 0; i < 3; ++i) step = std::min({step, middle[i] - corner[i], corner[i] + size - middle[i]});
        if (step < 1e-4) continue;
        const Vec3 a = middle - step * toward, b = middle + step * toward;
        const double difference =
            std::fabs((*f)(a.x, a.y, a.z) + (*f)(b.x, b.y, b.z) - 2 * (*f)(middle.x, middle.y, middle.z)) /
            (step * step);
        const double most = c.bend + 4 * c.error / (step * step);
        ASSERT_LE(difference, most) << (&expression - expressions.data());
        closest = std::max(closest, difference / most);
      }
    }
    EXPECT_GT(known, 500);
    EXPECT_GT(closest, 0.3);  // and not much too large
  }
}

TEST(Interval, SineHoldsAllSines) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 20000; ++n) {
    const double low = 200 * (unit(random) - 0.5), high = low + 7 * unit(random) * unit(random);
    const Interval s = sine({low, high}), c = cosine({low, high});
    for (int k = 0; k <= 20; ++k) {
      const double v = std::min(low + (high - low) * k / 20, high);
      ASSERT_TRUE(s.low <= std::sin(v) && std::sin(v) <= s.high);
      ASSERT_TRUE(c.low <= std::cos(v) && std::cos(v) <= c.high);
    }
    EXPECT_TRUE(high - low >= 0.5 || s.high - s.low < high - low + 1e-9);
  }
}

TEST(Interval, ProductsHoldAllProducts) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 20000; ++n) {
    const auto any = [&] {
      const double a = unit(random), b = unit(random);
      return Interval{std::min(a, b), std::max(a, b)};
    };
    const Interval a = any(), b = any(), product = a * b, sum = a + b, squared = square(a);
    const auto inside = [](const Interval& i, double v) { return i.low <= v && v <= i.high; };
    for (const double s : {0.0, 0.3, 1.0})
      for (const double t : {0.0, 0.6, 1.0}) {
        const double p = std::min(a.low + s * (a.high - a.low), a.high),
                     q = std::min(b.low + t * (b.high - b.low), b.high);
        ASSERT_TRUE(inside(product, p * q) && inside(sum, p + q) && inside(squared, p * p));
      }
  }
  EXPECT_FALSE((Interval::everything() * Interval{-1, 2}).finite());
}

}  // namespace
}  // namespace verisim::functions
