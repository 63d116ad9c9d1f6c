// The values of spec 05 section 15 (fractals), and orbits computed side by side.
#include <gtest/gtest.h>

#include <array>
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

struct Orbit {
  PatternKind kind;
  int magnet, exponent, iterations;
  std::array<double, 6> ends;
};

// All bits of POV-Ray's: real and imaginary parts of where orbits end, modulo 1, for three points, divided by 32, as
// `str(F(x, y, 0), 0, 24)` wrote them.
TEST(PatternProbes, LastBitsOfFractals) {
  const Orbit orbits[] = {
      Orbit{PatternKind::mandel,
            0,
            3,
            40,
            {0.010075466054429837309270, 0.010956614194259483435756, 0.113733389626842484876335,
             0.882630955316464183013636, 0.080326629162226020897108, 0.977265772193024240266368}},
      Orbit{PatternKind::mandel,
            0,
            4,
            40,
            {0.013622892944908026116591, 0.011231988558213921308715, 0.913749244313423636398852,
             0.708901160667581797802939, 0.068895770471272294033227, 0.971881825520089503989141}},
      Orbit{PatternKind::julia,
            0,
            5,
            2,
            {0.004943708070714290976622, 0.992974016964866756929098, 0.005763837367683905844873,
             0.993192306911103939270902, 0.003617981638155055423151, 0.993086253781028438503142}},
      Orbit{PatternKind::julia,
            0,
            12,
            1,
            {0.005031667151587791882161, 0.992996057875149329419173, 0.005063329991623459654104,
             0.993886643629939170452303, 0.005960774446655889638458, 0.991869589088470449134149}},
      Orbit{PatternKind::julia,
            0,
            33,
            1,
            {0.004933761707250912398326, 0.992970836428187175748405, 0.004932386135855545972184,
             0.992969450019225430281722, 0.004929037843855937212068, 0.992965060290116441343855}},
      Orbit{PatternKind::magnet_julia,
            2,
            2,
            9,
            {0.017964284445226595676726, 0.011675098276433967803278, 0.017982691568300131212954,
             0.011690962315418877703888, 0.017952435047174773730116, 0.011674194725835484315324}},
      Orbit{PatternKind::magnet_mandel,
            2,
            2,
            30,
            {0.003532782591663184961622, 0.991856331201983354439733, 0.031174338552942479352303,
             0.999806930070926247466900, 0.001439240591301862775761, 0.000694157311602939782261}},
  };
  const Vec3 points[3] = {{71193021, 43122199, 0}, {-60000017, 80119335, 0}, {104001171, -7120133, 0}};
  for (const Orbit& orbit : orbits)
    for (int n = 0; n < 6; ++n) {
      FractalParams f;
      f.magnet = orbit.magnet, f.exponent = orbit.exponent, f.iterations = orbit.iterations;
      f.julia = {21190333 * 0x1p-27, -30190013 * 0x1p-27};
      f.interior_type = f.exterior_type = 2 + n % 2, f.interior_factor = f.exterior_factor = 1.0 / 32;
      const double end = std::fmod(fractal(f, orbit.kind, points[n / 2] * 0x1p-27), 1.0);
      EXPECT_EQ(end < 0 ? end + 1 : end, orbit.ends[static_cast<std::size_t>(n)])
          << f.magnet << ", " << f.exponent << ", " << n;
    }
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

}  // namespace
}  // namespace verisim::textures
