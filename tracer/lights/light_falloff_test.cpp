#include "tracer/lights/light_falloff.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tracer/simd/instruction_sets.h"

namespace verisim::shading {
namespace {

class LightFalloffs : public testing::TestWithParam<int> {};

TEST_P(LightFalloffs, AreThoseOfEachPoint) {
  const LightFalloffKernels* kernels = light_falloff_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vec3(u(generator), u(generator), u(generator)); };
  const auto rays = std::make_unique<RayBatch>(), aimed = std::make_unique<RayBatch>();
  int dark = 0, dim = 0, bright = 0;
  for (int round = 0; round < 400; ++round) {
    scene::LightSource source;
    source.position = 4.0 * vector();
    if (round % 4 != 0) {
      source.kind = scene::LightKind::spotlight;
      source.direction = normalize(vector());
      source.tightness = round % 3;
      source.falloff = 90 + 60 * u(generator), source.radius = round % 5 == 0 ? source.falloff : 0.6 * source.falloff;
      if (round % 7 == 0) source.radius = -90;
    }
    if (round % 2 == 0) source.fade_power = round % 3, source.fade_distance = 2 + u(generator);
    const Light light(source, true);
    const auto falloff = LightFalloff::of(light);
    ASSERT_TRUE(falloff.has_value());
    const int count = 1 + round % RayBatch::kMax;
    double distance[RayBatch::kSize], aimed_distance[RayBatch::kSize];
    double found[RayBatch::kSize];
    for (int i = 0; i < count; ++i) {
      rays->origin.set(i, 5.0 * vector());
      const LightDirection to = light.direction(rays->origin.at(i));
      rays->direction.set(i, to.towards), distance[i] = to.distance;
    }
    *aimed = *rays;
    kernels->aim(source.position, count, *aimed, aimed_distance);
    for (int i = 0; i < count; ++i)
      ASSERT_TRUE(aimed->direction.at(i) == rays->direction.at(i) && aimed_distance[i] == distance[i])
          << round << ' ' << i;
    kernels->attenuate(*falloff, rays->direction, distance, count, found);
    for (int i = 0; i < count; ++i) {
      const double expected = light.attenuation(rays->origin.at(i), {rays->direction.at(i), distance[i]});
      ASSERT_EQ(found[i], expected) << round << ' ' << i;
      ++(expected == 0 ? dark : expected < 1 ? dim : bright);
    }
  }
  EXPECT_GT(dark, 300);
  EXPECT_GT(dim, 1000);
  EXPECT_GT(bright, 300);
}

TEST_P(LightFalloffs, AimAtEachSampleOfAnAreaLight) {
  const LightFalloffKernels* kernels = light_falloff_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(generator), unit(generator), unit(generator)); };
  const auto rays = std::make_unique<RayBatch>();
  const auto places = std::make_unique<GridPlaces>();
  for (int round = 0; round < 200; ++round) {
    scene::LightSource source;
    source.position = 4.0 * vector();
    source.area = true, source.axis1 = vector(), source.axis2 = vector();
    source.size1 = 1 + round % 5, source.size2 = 1 + round / 5 % 4;
    source.circular = source.size1 > 1 && source.size2 > 1 && round % 3 == 0, source.orient = round % 7 == 0;
    const Light light(source, true);
    const Vec3 p = 5.0 * vector();
    const Light::Axes axes = light.axes(light.direction(p).towards);
    const int count = 1 + round % RayBatch::kMax;
    for (int i = 0; i < count; ++i)
      places->u[i] = i % source.size1 + 0.5 * unit(generator), places->v[i] = i % source.size2 + 0.5 * unit(generator);
    double distance[RayBatch::kSize];
    kernels->aim_at_grid(LightGrid(light, axes), p, *places, count, *rays, distance);
    for (int i = 0; i < count; ++i) {
      const LightDirection expected = light.direction(p, light.offset(axes, places->u[i], places->v[i]));
      ASSERT_TRUE(rays->direction.at(i) == expected.towards && distance[i] == expected.distance) << round << ' ' << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, LightFalloffs, testing::Range(0, static_cast<int>(simd::kInstructionSets)));

TEST(LightFalloff, LeavesOtherLightsAlone) {
  scene::LightSource source;
  source.kind = scene::LightKind::spotlight, source.tightness = 10;
  EXPECT_FALSE(LightFalloff::of(Light(source, true)));
  source.kind = scene::LightKind::cylinder, source.tightness = 0;
  EXPECT_FALSE(LightFalloff::of(Light(source, true)));
  source.kind = scene::LightKind::point, source.fade_power = 1.5, source.fade_distance = 3;
  EXPECT_FALSE(LightFalloff::of(Light(source, true)));
}

}  // namespace
}  // namespace verisim::shading
