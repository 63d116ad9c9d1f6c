#include "tracer/math/polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace verisim {
namespace {

std::vector<double> from_roots(const std::vector<double>& roots) {
  std::vector<double> c{1};
  for (const double r : roots) {
    c.push_back(0);
    for (std::size_t i = c.size() - 1; i > 0; --i) c[i] -= r * c[i - 1];
  }
  return c;
}

std::vector<double> solve(const std::vector<double>& c, bool sturm = false, double elimination = 0) {
  double roots[kMaxPolynomialDegree];
  const int n = solve_polynomial(static_cast<int>(c.size()) - 1, c.data(), roots, sturm, elimination);
  std::vector<double> result(roots, roots + n);
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Polynomial, FindsKnownRoots) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> position(0.1, 10);
  for (int degree = 1; degree <= 8; ++degree) {
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<double> roots;
      while (static_cast<int>(roots.size()) < degree) {
        const double r = position(random);
        if (std::all_of(roots.begin(), roots.end(), [&](double other) { return std::fabs(other - r) > 0.5; }))
          roots.push_back(r);
      }
      std::sort(roots.begin(), roots.end());
      const auto c = from_roots(roots);
      for (const bool sturm : {false, true}) {
        const auto found = solve(c, sturm);
        ASSERT_EQ(found.size(), roots.size()) << "degree " << degree << " sturm " << sturm;
        for (std::size_t i = 0; i < roots.size(); ++i) ASSERT_NEAR(found[i], roots[i], 1e-5) << "degree " << degree;
      }
    }
  }
}

TEST(Polynomial, DropsTinyLeadingCoefficients) { EXPECT_EQ(solve({1e-11, 0, 1, -3}), std::vector<double>{3}); }

TEST(Polynomial, QuadraticMergesNearlyEqualRoots) {
  EXPECT_EQ(solve({1, -2, 1}).size(), 1u);
  EXPECT_EQ(solve({1, -2, 1 - 2e-11}).size(), 1u);
  EXPECT_EQ(solve({1, -2, 1 - 1e-9}).size(), 2u);
}

// (x - 0.75)^2 (x - 2.75) (x + 0.75): where rounding leaves two roots as one, it is mirrored at the mean of all four.
TEST(Polynomial, QuarticMisplacesDoubleRoots) {
  EXPECT_EQ(solve(from_roots({0.75, 0.75, 2.75, -0.75})), (std::vector<double>{-1, -0.75, 2.75}));
}

TEST(Polynomial, EliminatesTheRootAtTheStart) {
  const auto c = from_roots({1e-6, 1, 2, 3});
  EXPECT_EQ(solve(c, false, 1e-4).size(), 3u);
  EXPECT_EQ(solve(c, false, 0).size(), 4u);
}

TEST(Polynomial, SturmIgnoresNegativeRoots) {
  EXPECT_EQ(solve(from_roots({-3, -1, 2, 5, 7}), true).size(), 3u);
  EXPECT_EQ(solve(from_roots({-3, -1, 2, 5})).size(), 4u);
}

TEST(Polynomial, SturmReportsMultipleRootsOnce) {
  const auto found = solve(from_roots({2, 2, 5}), true);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 2, 1e-4);
  EXPECT_NEAR(found[1], 5, 1e-6);
}

// Values of POV-Ray's (trace() at polys of x, all digits): where regula falsi does not come to an end, fifty bisections
// of 0 .. 1e7 follow, and the last middle counts.
TEST(Polynomial, SturmBisectsWhereRegulaFalsiFails) {
  const std::pair<std::vector<double>, double> known[] = {
      {{0.010009765625, -0.083740234375, -0.725341796875, -2.1240234375, 16.087646484375, -19.736572265625},
       14.063787547868856},
      {{1, -23.766845703125, 237.049072265625, -1311.369140625, 4473.838623046875, -7927.693603515625},
       6.41598068007454},
      {{7, -129.15771484375, 60.2548828125, -164.922119140625}, 18.046463017284964},
      {{0.10009765625, -1.46728515625, 7.094482421875, -11.277587890625}, 3.8517388301073652},
  };
  for (const auto& [c, root] : known) EXPECT_EQ(solve(c, true), std::vector<double>{root});
}

// Values of POV-Ray's, too, of squares: the last bits of the sequence decide where halving ends.
TEST(Polynomial, SturmFindsDoubleRootsWherePovRayDoes) {
  const std::pair<std::vector<double>, double> known[] = {
      {{6.25, -21.875, 26.953125, -13.671875, 2.44140625}, 0.5000000043591826},
      {{14.0625, -56.25, 82.6171875, -52.734375, 12.359619140625}, 0.7500000058022616},
      {{3.0625, -19.90625, 48.42578125, -52.25390625, 21.1025390625}, 1.4999998382275854},
      {{12.25, -134.75, 617.09375, -1505.984375, 2065.7041015625, -1510.00390625, 459.56640625}, 1.750381867999585},
      {{5.0625, -22.78125, 43.34765625, -44.61328125, 26.1826171875, -8.3056640625, 1.11236572265625},
       0.7499998755378101},
  };
  for (const auto& [c, root] : known) {
    const std::vector<double> found = solve(c, true);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(*std::min_element(found.begin(), found.end()), root);
  }
}

// What is asked for is the same whether the rest is, too.
TEST(Polynomial, SturmLeavesOutWhatIsNotWanted) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(0.01, 10), offset(-3, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> roots;
    for (int k = 0; k < 3 + trial % 3; ++k) roots.push_back(place(random));
    auto c = from_roots(roots);
    if (trial % 2) c.back() += offset(random);
    const double from = place(random), to = from + place(random);
    const auto wanted = [&](double low, double high) {
      double found[kMaxPolynomialDegree];
      const int n = solve_sturm(static_cast<int>(c.size()) - 1, c.data(), found, low, high);
      std::vector<double> result;
      std::copy_if(found, found + n, std::back_inserter(result), [&](double r) { return r >= from && r <= to; });
      return result;
    };
    ASSERT_EQ(wanted(from, to), wanted(0, HUGE_VAL)) << trial;
  }
}

TEST(Polynomial, SurvivesAnything) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-40, 40);
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<double> c;
    const int degree = trial % 11;
    for (int i = 0; i <= degree; ++i) c.push_back((random() & 1 ? 1 : -1) * std::pow(10, exponent(random)));
    if (trial % 7 == 0) c[random() % c.size()] = random() & 1 ? HUGE_VAL : std::nan("");
    EXPECT_LE(solve(c, trial & 1, 1e-4).size(), static_cast<std::size_t>(degree));
  }
}

// Polynomials with known roots, their coefficients formed in extended precision: every root is found, close to what the
// rounding of the coefficients allows. The closed form of quartics is POV-Ray's and, as there, not polished (spec 03
// section 3, step 5): it has fewer digits where roots are near each other.
// Of (x + far)^n = b: a surface of a high degree seen from far away. Noise in the chain promises dozens of roots.
TEST(Polynomial, SturmFindsNoMoreRootsThanTheDegree) {
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  for (int i = 0; i < 20000; ++i) {
    const int n = 5 + i % 11;
    const double far = number(random) * std::pow(10, i % 9);
    std::vector<double> c{1};
    for (int k = 0; k < n; ++k) c.push_back(c.back() * far * (n - k) / (k + 1));
    c.back() -= number(random);
    std::vector<double> roots(1000, -1);
    ASSERT_LE(solve_sturm(n, c.data(), roots.data()), n) << far;
    ASSERT_EQ(roots[static_cast<std::size_t>(n)], -1) << far;
  }
}

TEST(Polynomial, FindsTheRootsOfRandomPolynomials) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(0.01, 10), gap(0.05, 3);
  for (int degree = 2; degree <= 8; ++degree) {
    for (int n = 0; n < 2000; ++n) {
      std::vector<double> known;
      double at = place(random) * 0.3;
      for (int k = 0; k < degree; ++k) known.push_back(at), at += gap(random);
      std::vector<long double> product{1};
      for (const double root : known) {
        product.push_back(0);
        for (std::size_t k = product.size() - 1; k > 0; --k)
          product[k] -= product[k - 1] * static_cast<long double>(root);
      }
      std::vector<double> c(product.begin(), product.end()), roots(static_cast<std::size_t>(degree));
      const int count = solve_polynomial(degree, c.data(), roots.data());
      ASSERT_EQ(count, degree);
      std::sort(roots.begin(), roots.end());
      for (int k = 0; k < degree; ++k) {
        // How far a rounding error of the coefficients moves this root.
        const double r = known[static_cast<std::size_t>(k)];
        double size = 0, slope = 1;
        for (const double v : c) size = size * r + std::fabs(v);
        for (int j = 0; j < degree; ++j)
          if (j != k) slope *= std::fabs(r - known[static_cast<std::size_t>(j)]);
        ASSERT_NEAR(roots[static_cast<std::size_t>(k)], r, (degree == 4 ? 1e-5 : 1e-9) + 1e-14 * size / slope)
            << "degree " << degree << " case " << n;
      }
    }
  }
}

}  // namespace
}  // namespace verisim
