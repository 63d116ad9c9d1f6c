// The values of spec 05 section 15 (fractals), and orbits computed side by side.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tracer/simd/instruction_sets.h"
#include "tracer/textures/patterns/fractal_kernels.h"
#include "tracer/textures/patterns/probe_test_support.h"

namespace verisim::textures {
namespace {

TEST(PatternProbes, Fractals) {
  const Vec3 points[5] = {{0.3, 0.2, 0}, {-0.75, 0.1, 0}, {0.4, -0.6, 0}, {-1.3, 0.02, 0}, {0.1, 0.8, 0}};
  const Probe probes[] = {
      {"mandel 25",
       [] {
         Pattern p = make(PatternKind::mandel);
         {
           FractalParams f;
           f.iterations = 25;
           p.params = f;
         }
         return p;
       },
       {1, 1, 0.52, 1, 0.16}},
      {"mandel 25 interior 1,1",
       [] {
         Pattern p = make(PatternKind::mandel);
         {
           FractalParams f;
           f.iterations = 25;
           f.interior_type = 1, f.interior_factor = 1;
           p.params = f;
         }
         return p;
       },
       {0.338534677077, 0.203730827319, 0.52, 0.037570703233, 0.16}},
      {"mandel 25 exponent 5",
       [] {
         Pattern p = make(PatternKind::mandel);
         {
           FractalParams f;
           f.iterations = 25;
           f.exponent = 5;
           p.params = f;
         }
         return p;
       },
       {1, 0.08, 1, 0, 0.04}},
      {"julia <0.3,0.5>,30 exterior 6,0.1",
       [] {
         Pattern p = make(PatternKind::julia);
         {
           FractalParams f;
           f.julia = {0.3, 0.5};
           f.iterations = 30;
           f.exterior_type = 6, f.exterior_factor = 0.1;
           p.params = f;
         }
         return p;
       },
       {0.212313343366, 0.248494647177, 1, 0.203941466112, 1}},
      {"magnet 1 mandel 30",
       [] {
         Pattern p = make(PatternKind::magnet_mandel);
         {
           FractalParams f;
           f.magnet = 1;
           f.iterations = 30;
           p.params = f;
         }
         return p;
       },
       {1, 0.133333333333, 1, 0.1, 1}},
      {"magnet 2 julia <0.3,0.5>,30 interior 6,0.5",
       [] {
         Pattern p = make(PatternKind::magnet_julia);
         {
           FractalParams f;
           f.magnet = 2;
           f.julia = {0.3, 0.5};
           f.iterations = 30;
           f.interior_type = 6, f.interior_factor = 0.5;
           p.params = f;
         }
         return p;
       },
       {0.198432376537, 0.198432376569, 0.198432376575, 0.198432376575, 0.19843237655}},
  };
  check(probes, points, 2e-12);
}

// Orbits that go round for ever end where step by step iteration ends, with the same bits.
TEST(PatternProbes, LongOrbitsOfFractals) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> real(-1.4, 0.4), imaginary(-0.8, 0.8);
  int stay = 0;
  for (int n = 0; n < 300; ++n) {
    FractalParams f;
    f.iterations = 1500 + n % 7, f.interior_type = 1 + n % 6, f.interior_factor = 0.7;
    const Vec3 p(real(random), imaginary(random), 0);
    double a = p.x, b = p.y, size = a * a + b * b, smallest = size;
    for (int k = 0; k < f.iterations && size <= 4; ++k) {
      const double square = a * a - b * b + p.x;
      b = 2 * a * b + p.y, a = square;
      size = a * a + b * b;
      smallest = std::min(smallest, size);
    }
    if (size > 4) continue;
    ++stay;
    const double expected[] = {std::sqrt(smallest) * 0.7, a * 0.7, b * 0.7, a * a * 0.7, b * b * 0.7,
                               a * a + b * b * 0.7};
    EXPECT_EQ(fractal(f, PatternKind::mandel, p), expected[f.interior_type - 1]) << n;
  }
  EXPECT_GT(stay, 100);
}

// Eight orbits at once end as each does alone, with every instruction set.
TEST(PatternProbes, OrbitsSideBySide) {
  std::mt19937 random{12};
  std::uniform_real_distribution<double> real(-1.5, 0.5), imaginary(-1, 1);
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const OrbitKernels* kernels = orbit_kernels(set);
    if (!kernels) continue;
    for (int n = 0; n < 60; ++n) {
      FractalParams f;
      f.iterations = n % 9 == 0 ? 0 : 40 * n, f.exponent = 2 + n % 4, f.julia = {real(random), imaginary(random)};
      f.exterior_type = n % 9, f.exterior_factor = 3.5, f.interior_type = n % 7, f.interior_factor = 0.7;
      constexpr PatternKind kKinds[] = {PatternKind::julia, PatternKind::mandel, PatternKind::magnet_julia,
                                        PatternKind::magnet_mandel};
      const PatternKind kind = kKinds[n % 4];
      f.magnet = 1 + n / 4 % 2;
      double x[40], y[40], values[40];
      for (int i = 0; i < 40; ++i) x[i] = real(random), y[i] = imaginary(random);
      const int count = 33 + n % 8;
      fractal_batch(f, kind, count, x, y, values, *kernels);
      for (int i = 0; i < count; ++i)
        ASSERT_EQ(values[i], fractal(f, kind, {x[i], y[i], 0})) << "set " << set << " case " << n << " point " << i;
    }
  }
}

}  // namespace
}  // namespace verisim::textures
