// The formulas of shading against the numbers of spec 06.
#include <gtest/gtest.h>

#include "tracer/math/constants.h"
#include "tracer/shading/dispersion.h"
#include "tracer/shading/finish.h"
#include "tracer/shading/atmosphere/fog.h"
#include "tracer/lights/light.h"
#include "tracer/shading/atmosphere/rainbow.h"
#include "tracer/shading/random.h"

namespace verisim::shading {
namespace {

TEST(Dispersion, HueWeightsOfSevenSamples) {
  const float expected[7][3] = {
      {.2555f, 0, 1.4329f},  {.0210f, 0, 2.5655f},  {0, .7665f, 2.2890f}, {.0686f, 2.5284f, .6860f},
      {1.8956f, 2.6509f, 0}, {2.9169f, 1.0542f, 0}, {1.7990f, 0, 0}};
  for (int i = 0; i < 7; ++i) {
    const Rgb h = spectral_weight(i, 7);
    EXPECT_NEAR(h.r, expected[i][0], 1e-4) << i;
    EXPECT_NEAR(h.g, expected[i][1], 1e-4) << i;
    EXPECT_NEAR(h.b, expected[i][2], 1e-4) << i;
  }
}

TEST(Dispersion, WhiteLosesItsEndsForAnyNumberOfSamples) {
  for (int n : {2, 3, 7, 20, 100}) {
    Rgb sum;
    for (int i = 0; i < n; ++i) sum += spectral_weight(i, n) * (1.0f / static_cast<float>(n));
    EXPECT_NEAR(sum.r, 0.9938, 2e-4) << n;
    EXPECT_NEAR(sum.g, 1, 2e-4) << n;
    EXPECT_NEAR(sum.b, 0.9962, 2e-4) << n;
  }
}

TEST(Dispersion, RedIsBentLessThanViolet) {
  // Entering glass of ior 1.5 and dispersion 1.1: relative dispersion 1/1.1.
  const double red = 1 / ratio_at(1 / 1.5, 1 / 1.1, kRedWavelength),
               violet = 1 / ratio_at(1 / 1.5, 1 / 1.1, kVioletWavelength);
  EXPECT_LT(red, 1.5);
  EXPECT_GT(violet, 1.5);
  EXPECT_NEAR(violet / red, 1.1, 1e-12);
}

TEST(Random, ReplayIsPovRaysStream) {
  RandomSource random(true, 0);
  for (double u : {0.1354770, 0.9057919, 0.8350086, 0.1269868, 0.9688678, 0.9133759})
    EXPECT_NEAR(random.shading(), u, 5e-8);
  EXPECT_NEAR(random.media(), 0.1354770, 5e-8);
  // Element 0 comes after element 32767.
  RandomSource round(true, 0);
  for (int i = 0; i < 32767; ++i) round.shading();
  EXPECT_NEAR(round.shading(), 0.814723691903055, 1e-12);
  EXPECT_DOUBLE_EQ(random.crand(), 12345 / 4294967295.0);
}

TEST(Random, CountersDependOnTheSampleAlone) {
  RandomSource a(false, 7), b(false, 7), other(false, 8);
  a.begin_sample(3, 4, 0);
  a.shading();
  a.media();
  a.begin_sample(5, 4, 1);
  b.begin_sample(5, 4, 1);
  other.begin_sample(5, 4, 1);
  const double first = a.shading();
  EXPECT_EQ(first, b.shading());
  EXPECT_NE(first, other.shading());
  EXPECT_NE(first, a.shading());
  b.begin_sample(4, 5, 1);
  EXPECT_NE(first, b.shading());
}

TEST(Random, CountersAreUniform) {
  RandomSource random(false, 1);
  double sum = 0, squares = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    random.begin_sample(i % 320, i / 320, 0);
    const double u = random.shading();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u, squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 0.005);
  EXPECT_NEAR(squares / n, 1.0 / 3, 0.005);
}

TEST(Finish, HighlightsOfTheProbes) {
  const Vec3 n(0, 0, -1), d(0, 0, 1);
  const double a = 20 * kPi / 180;
  const Vec3 l(std::sin(a), 0, -std::cos(a));
  scene::Finish finish;
  finish.phong = .8f;
  EXPECT_NEAR(highlight_strength(finish, n, d, l) * 65535, 4355, 1);
  finish.specular = .8f;
  EXPECT_NEAR(strength(blinn_highlight(finish), blinn_cosine(n, d, l)) * 65535, 38600, 2);
  finish.phong_size = 60;
  EXPECT_EQ(strength(phong_highlight(finish), phong_cosine(n, d, Vec3(std::sqrt(1 - .0008 * .0008), 0, -.0008))), 0);
}

TEST(Finish, FresnelLimits) {
  EXPECT_NEAR(fresnel_reflectance(1.5, 1), 0.04, 1e-12);
  EXPECT_NEAR(fresnel_reflectance(1.5, 0), 1, 1e-12);
  EXPECT_EQ(fresnel_reflectance(1 / 1.5, 0.5), 1);
  EXPECT_NEAR(fresnel_reflectance(1, 0.3), 0, 1e-12);
}

TEST(Finish, ReflectionsStayAboveTheSurface) {
  const Vec3 geometric_normal(0, 0, -1), d = normalize(Vec3(1, 0, 0.05));
  for (double tilt = -1.5; tilt <= 1.5; tilt += 0.01) {
    const Vec3 normal(std::sin(tilt), 0, -std::cos(tilt)), r = reflected_direction(d, normal, geometric_normal);
    EXPECT_GE(dot(r, geometric_normal), -1e-12) << tilt;
    EXPECT_NEAR(length(r), 1, 1e-12);
  }
}

TEST(Light, SpotlightOfProbeL2) {
  scene::LightSource source;
  source.position = {0, 6, 0}, source.color = Rgb(1), source.kind = scene::LightKind::spotlight;
  source.direction = {0, -1, 0}, source.radius = 30, source.falloff = 45;
  const Light light(source, true);
  const Vec3 p(4.8125, 0, 0);
  const LightDirection l = light.direction(p);
  EXPECT_NEAR(light.attenuation(p, l) * l.towards.y * 65535, 22436, 2);
  const Vec3 behind(0, 12, 0);
  EXPECT_EQ(light.attenuation(behind, light.direction(behind)), 0);
}

TEST(Light, ParallelDistanceMayBeNegative) {
  scene::LightSource source;
  source.position = {0, -4, 0}, source.parallel = true, source.direction = {0, -1, 0}, source.color = Rgb(1);
  const Light light(source, true);
  const LightDirection l = light.direction({3, 0, 0});
  EXPECT_EQ(l.towards, Vec3(0, 1, 0));
  EXPECT_EQ(l.distance, -4);
}

TEST(Fog, GroundFogIsContinuousAcrossItsOffset) {
  for (double y : {-2.0, -0.5, 0.5, 3.0}) {
    const double below = ground_fog_density(y, 1 - 1e-9, 1, 0.7), above = ground_fog_density(y, 1 + 1e-9, 1, 0.7);
    EXPECT_NEAR(below, above, 1e-6) << y;
  }
  EXPECT_NEAR(ground_fog_density(1.7, 1.7, 1, 0.7), 0.5, 1e-12);
  EXPECT_EQ(ground_fog_density(-5, 0, 1, 0.7), 1);
}

TEST(Fog, ProbeA1) {
  scene::Fog fog;
  fog.distance = 8, fog.color = {.2f, .5f, .8f, .5f, .1f};
  const FogEffect e = fog_along(std::span(&fog, 1), Ray{{0, 0, 0}, {0, 0, 1}}, 5, 2);
  const Rgb c = e.added + e.passed() * Rgb(.9f, .6f, .3f);
  EXPECT_NEAR(c.r * 65535, 25034, 2);
  EXPECT_NEAR(c.g * 65535, 31014, 2);
  EXPECT_NEAR(c.b * 65535, 33836, 2);
}

}  // namespace
}  // namespace verisim::shading
