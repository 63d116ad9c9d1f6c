#include "tracer/noise/noise.h"

#include <gtest/gtest.h>

#include <random>

#include "tracer/noise/noise_kernels.h"
#include "tracer/noise/noise_tables.h"

namespace verisim::textures {
namespace {

TEST(NoiseTables, MatchTheChecksOfTheSpecification) {
  const NoiseTables& t = noise_tables();
  const int hash[8] = {2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(t.hash[i], hash[i]) << i;
  const double random[3] = {0.814723691903055, 0.135477004107088, 0.905791934113949};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(random_value(t, i), random[i], 1e-15) << i;
  EXPECT_EQ(t.values[0], -1);
  EXPECT_EQ(t.values[1], 0.604974);
  EXPECT_EQ(t.values[266], 0.566186);
  EXPECT_NEAR(t.gradient_rows[0][1], 0.604425069426, 1e-12);
  EXPECT_NEAR(t.gradient_rows[0][2], 0.705260289544, 1e-12);
  EXPECT_NEAR(t.gradient_rows[0][3], 0.370510808805, 1e-12);
  const int permutation[6] = {0, 1, 386, 3, 649, 1576};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(t.permutation[i], permutation[i]) << i;
}

// Probe P2: f_noise_generator of functions.inc.
TEST(Noise, EqualsPovRay) {
  struct Probe {
    Vec3 p;
    double value[3];
  };
  const Probe probes[] = {
      {{0.5, 0.5, 0.5}, {0.41346047125, 0.473142170266155, 0.672103843552658}},
      {{1.25, -2.75, 3.6}, {0.339298602446094, 0.436813547210485, 0.445168696205204}},
      {{-7.3, 0.2, 12.9}, {0.0171818543569405, 0.27902278343954, 0.612870118066848}},
      {{100.125, -55.5, 2.25}, {0.659942089523315, 0.593882625500357, 0.367861124864211}},
      {{-0.1, -0.2, -0.3}, {0.0243576697584844, 0.282537898377232, 0.34813195163302}},
  };
  for (const Probe& probe : probes)
    for (int g = 1; g <= 3; ++g)
      EXPECT_NEAR(noise(probe.p, g), probe.value[g - 1], 2e-15) << "generator " << g << " at x = " << probe.p.x;
}

// vturbulence(2, 0.5, 1, P).
TEST(Noise, VectorsHaveAllBits) {
  struct Probe {
    Vec3 p, value;
  };
  const Probe probes[] = {
      {{0.926409106271656, -3.6957720391485727, 1.2572030410805404},
       {-0.03295501495315023, -0.08525968316791263, 0.2264046014802011}},
      {{0.6471410224665288, -0.46113666187600666, 0.4282589672224051},
       {-0.15764428908315475, -0.3945759379110634, 0.03780669732479455}},
      {{18.19821366349666, 42.8945601200017, 49.09896448688151},
       {-0.34793292990325847, 0.4681549301056055, 0.56599850869309}},
      {{745.5340492564026, -1.0, -244.3904620641399}, {0.298628602767646, 0.38067638138815213, 0.023461906093692503}},
      {{287.7774367754537, -1.0, 240.25227089052396},
       {0.19278834125096236, -0.007403711445265084, 0.06288888414127515}},
      {{10.88639177899826, -22.107558892641755, -47.78175310091901},
       {-0.40148623089483837, -0.23698676770335408, -0.08104454376728239}},
      {{1.537232831404184, -2.3062186510342975, -3.1260565908205806},
       {-0.12610812772587238, -0.18024620760956658, -0.021787467336797553}},
      {{30.722641816695358, 14.19372564966531, 8.94807512289966},
       {0.5209209343508535, 0.16860940437152067, 0.1404979557641748}},
  };
  for (const Probe& probe : probes) EXPECT_EQ(vector_noise(probe.p), probe.value) << probe.p.x;
}

// f_noise3d(x, y, z), pattern { granite }, pattern { wrinkles }: their sums have POV-Ray's order.
TEST(Noise, NumbersHaveAllBits) {
  struct Probe {
    Vec3 p;
    double noise, granite, wrinkles;
  };
  const Probe probes[] = {
      {{0.9832135591176154, 1.9342959140858351, 2.361548524525573},
       0.5104168585964278,
       0.36950022858152404,
       0.5806657897478413},
      {{3.5396022702164025, 1.9191885979194456, 3.378599973323336},
       0.5172444816250664,
       0.45897798259104045,
       0.5062863344603036},
      {{-3.767958173731082, -0.2750187649751572, 3.5468537359865095},
       0.45493939754029883,
       0.4917654571423088,
       0.39380843456219466},
      {{1.1917964250953936, 3.2072039340049816, -3.094352282774845},
       0.5689457564820493,
       0.4229591256977146,
       0.6847507116895074},
      {{-0.24744761774269008, -2.0274173390413575, 0.3500868738874434},
       0.6514060044986084,
       0.3326962332221923,
       0.7678556948370358},
      {{0.5915295034248063, -3.8950864832887824, -2.2661615962892148},
       0.5102366295755655,
       0.20806474012777335,
       0.5389738687153832},
  };
  for (const Probe& probe : probes) {
    EXPECT_EQ(noise(probe.p, 2), probe.noise) << probe.p.x;
    EXPECT_EQ(granite_sum(probe.p, 2), probe.granite) << probe.p.x;
    EXPECT_EQ(wrinkles_sum(probe.p, 2), probe.wrinkles) << probe.p.x;
  }
}

// vturbulence(2, 0.5, 6, P).
TEST(Turbulence, OfVectorsHasAllBits) {
  struct Probe {
    Vec3 p, value;
  };
  const Probe probes[] = {
      {{0.9832135591176154, 1.9342959140858351, 2.361548524525573},
       {0.09336766162414536, -0.19369378218856456, -0.04457416410594179}},
      {{3.5396022702164025, 1.9191885979194456, 3.378599973323336},
       {-0.04439696211715836, 0.31139393726261394, -0.21079208583804238}},
      {{-3.767958173731082, -0.2750187649751572, 3.5468537359865095},
       {-0.27415098348260497, -0.1375152360191372, -0.02753611533221464}},
      {{1.1917964250953936, 3.2072039340049816, -3.094352282774845},
       {0.31131688300504445, 0.2669199717278347, 0.3839987673858879}},
      {{-0.24744761774269008, -2.0274173390413575, 0.3500868738874434},
       {0.49014344409287514, -0.2770382214668853, -0.7459559033428744}},
      {{0.5915295034248063, -3.8950864832887824, -2.2661615962892148},
       {0.012373198941485426, 0.12544597949475217, -0.2963718271519846}},
  };
  for (const Probe& probe : probes) EXPECT_EQ(vector_turbulence(probe.p, 6, 2, 0.5), probe.value) << probe.p.x;
}

TEST(Noise, FastVersionAgreesWithTheReference) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const double size = std::pow(10.0, i % 7 - 2);
    const Vec3 p(size * coordinate(random), size * coordinate(random), size * coordinate(random));
    for (int g = 1; g <= 3; ++g) ASSERT_EQ(noise(p, g), reference::noise(p, g)) << "generator " << g;
    ASSERT_EQ(vector_noise(p), reference::vector_noise(p));
  }
}

TEST(NoiseKernels, AgreeWithTheReferenceOnEveryInstructionSet) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Octaves octaves[] = {Octaves(6, 2, 0.5), Octaves(10, 2.17, 0.63), Octaves(1, 3, 0.1)};
  for (int i = 0; i < 20000; ++i) {
    const double size = std::pow(10.0, i % 7 - 2);
    Vec3 p(size * coordinate(random), size * coordinate(random), size * coordinate(random));
    if (i % 16 == 0) p = Vec3(std::round(p.x), std::round(p.y), p.z);  // lattice points
    const Octaves& o = octaves[i % 3];
    const auto expect = [&](const auto& expected, const auto& value) {
      for (int set = 0; set <= simd::best_instruction_set(); ++set) {
        const NoiseKernels& kernels = noise_kernels(static_cast<simd::InstructionSet>(set));
        EXPECT_EQ(value(kernels), expected) << kernels.name << ' ' << i;
      }
    };
    expect(reference::vector_noise(p), [&](const NoiseKernels& k) { return k.vector_noise(p); });
    expect(reference::vector_turbulence(p, o), [&](const NoiseKernels& k) { return k.vector_turbulence(p, o); });
    expect(reference::wrinkles_vector_sum(p), [&](const NoiseKernels& k) { return k.wrinkles_vector(p); });
    for (int g = 1; g <= 3; ++g) {
      expect(reference::noise(p, g), [&](const NoiseKernels& k) { return k.noise[g](p); });
      expect(reference::turbulence(p, o, g), [&](const NoiseKernels& k) { return k.turbulence[g](p, o); });
      expect(reference::granite_sum(p, g), [&](const NoiseKernels& k) { return k.granite[g](p); });
      expect(reference::wrinkles_sum(p, g), [&](const NoiseKernels& k) { return k.wrinkles[g](p); });
    }
    if (HasFailure()) return;
  }
}

// Several points: neighbours, octaves, cells whose places in the memory are the same, and far ones.
TEST(NoiseKernels, SeveralPointsGetWhatEachGets) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> within(0, 1);
  const double steps[] = {1, 128, 256, 512, 1024, 2048};
  for (int i = 0; i < 9000; ++i) {
    EightPoints points;
    double step = steps[i % 6];
    const auto coordinate = [&](int most) {
      return step * static_cast<double>(random() % static_cast<unsigned>(most)) - 1000 + within(random);
    };
    for (int k = 0; k < 8; ++k, step *= i % 7 == 0 ? 2.17 : 1)
      points.x[k] = coordinate(1 + i % 5), points.y[k] = coordinate(1 + i % 3), points.z[k] = coordinate(2);
    if (i % 50 == 0) points.y[i % 8] = 1e11;
    const unsigned wanted = i % 3 == 0 ? static_cast<unsigned>(random() & 255) : first_of_eight(1 + i % 8);
    for (int set = 0; set <= simd::best_instruction_set(); ++set) {
      const NoiseKernels& kernels = noise_kernels(static_cast<simd::InstructionSet>(set));
      for (int g = 1; g <= 3; ++g) {
        alignas(64) double together[8];
        kernels.noises[g](points, wanted, together);
        for (int k = 0; k < 8; ++k) {
          if (!(wanted >> k & 1)) continue;
          const Vec3 p(points.x[k], points.y[k], points.z[k]);
          ASSERT_EQ(together[k], reference::noise(p, g)) << kernels.name << ' ' << g << ' ' << i;
        }
      }
    }
  }
}

TEST(Noise, SurvivesFarAndInvalidCoordinates) {
  for (const double x : {1e17, -1e17, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    for (int g = 1; g <= 3; ++g) {  // must not crash
      noise({x, 0.5, x}, g);
      turbulence({x, 0.5, x}, 6, 1e40, 0.5, g);
      granite_sum({x, 0.5, x}, g);
      wrinkles_sum({x, 0.5, x}, g);
    }
    wrinkles_vector_sum({x, x, x});
    vector_turbulence({x, x, 1}, 10, 3, 0.5);
  }
}

TEST(Turbulence, IsTheSumOfItsOctaves) {
  const Vec3 p(1.25, -2.75, 3.6);
  double first = 0;
  for (int i = 0; i < 4; ++i) first += std::pow(0.6, i) * reference::noise(p * std::pow(2.5, i), 1);
  EXPECT_NEAR(turbulence(p, 4, 2.5, 0.6, 1), first, 1e-14);
  double second = std::clamp(2 * reference::noise(p, 2) - 0.5, 0.0, 1.0);
  for (int i = 1; i < 4; ++i) second += std::pow(0.6, i) * (2 * reference::noise(p * std::pow(2.5, i), 2) - 0.5);
  EXPECT_NEAR(turbulence(p, 4, 2.5, 0.6, 2), second, 1e-14);
  Vec3 vector(0, 0, 0);
  for (int i = 0; i < 4; ++i) vector += std::pow(0.6, i) * reference::vector_noise(p * std::pow(2.5, i));
  EXPECT_NEAR(length(vector_turbulence(p, 4, 2.5, 0.6) - vector), 0, 1e-14);
}

}  // namespace
}  // namespace verisim::textures
