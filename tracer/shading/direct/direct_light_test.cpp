// Lights that are asked together from one point give what they give one after another.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tracer/shading/explain.h"
#include "tracer/shading/tracer.h"
#include "tracer/shapes/test_support.h"

namespace verisim::shading {
namespace {

// Opaque boxes, balls and triangles, some of two layers, between `lights` lights of several kinds.
scene::Scene lit_scene(int lights) {
  using shapes::testing::make;
  scene::Scene scene;
  std::mt19937 random{9};
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < lights; ++i) {
    scene::LightSource light;
    light.position = {4 * u(random), 5 + u(random), 4 * u(random)};
    light.color = Rgb(0.3f, 0.2f, 0.1f + 0.05f * static_cast<float>(i));
    if (i % 4 == 1) light.fade_power = 2, light.fade_distance = 6;
    if (i % 5 == 2)
      light.kind = scene::LightKind::spotlight, light.direction = Vec3(0, -1, 0), light.radius = 20, light.falloff = 40;
    if (i % 5 == 3) light.kind = scene::LightKind::shadowless;
    if (i % 7 == 4) light.color = Rgb();
    scene.objects.push_back(make(scene::Boxed<scene::LightSource>(light)));
  }
  const auto add = [&](const auto& shape, bool layered) {
    auto texture = std::make_shared<scene::Texture>();
    for (int layer = layered ? 0 : 1; layer < 2; ++layer) {
      auto pigment = std::make_shared<scene::Pigment>();
      pigment->pattern.kind = scene::PatternKind::plain;
      pigment->color = layer == 0 ? Color(0.8f, 0.4f, 0.1f, 0.5f, 0.2f) : Color(0.3f, 0.6f, 0.9f);
      scene::Finish finish;
      finish.phong = 0.5f;
      if (layered) finish.diffuse_back = 0.3f;
      texture->layers.push_back({pigment, nullptr, finish});
    }
    const auto object = make(shape);
    object->texture = texture;
    object->interior = std::make_shared<scene::Interior>();
    scene.objects.push_back(object);
  };
  add(scene::Box{{-5, -0.1, -5}, {5, 0, 5}}, false);
  for (int i = 0; i < 40; ++i) {
    const Vec3 p(4 * u(random), 2 + 2 * u(random), 4 * u(random));
    const auto beside = [&] { return p + Vec3(u(random), u(random), u(random)) * 0.8; };
    if (i % 3 == 0)
      add(scene::Sphere{p, 0.5}, i % 2 == 0);
    else if (i % 3 == 1)
      add(scene::Triangle{{beside(), beside(), beside()}}, i % 2 == 0);
    else
      add(scene::Box{p - Vec3(0.3), p + Vec3(0.4)}, i % 2 == 0);
  }
  return scene;
}

class DirectLight : public testing::TestWithParam<int> {};

TEST_P(DirectLight, OfLightsAskedTogetherIsThatOfEach) {
  const scene::Scene scene = lit_scene(GetParam());
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  ASSERT_FALSE(world.has_transparent_shadows());
  const SceneData data(scene, world, compiler, 9, false);
  Tracer together(data, RandomSource(false, 0)), each(data, RandomSource(false, 0));
  Observer watching;  // wants to hear of the lights one by one
  each.set_observer(&watching);
  std::mt19937 random{4};
  std::uniform_real_distribution<double> u(-4, 4);
  int lit = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 from(u(random), 3 + 0.5 * u(random), u(random));
    RayState ray;
    ray.ray = {from, normalize(Vec3(u(random), -3, u(random)))};
    ray.primary = false;
    ray.gather = i % 2 == 0;
    const Color expected = each.trace(ray);
    ASSERT_TRUE(together.trace(ray) == expected) << i;
    lit += expected.rgb() != Rgb();
  }
  EXPECT_GT(lit, 1000);
  EXPECT_EQ(together.statistics().shadow_rays, each.statistics().shadow_rays);
  EXPECT_GT(each.statistics().shadow_rays, 3000u);
}

// One row, more than one, and more lights than a batch has places.
INSTANTIATE_TEST_SUITE_P(Lights, DirectLight, testing::Values(3, 9, 2 * RayBatch::kMax + 5));

}  // namespace
}  // namespace verisim::shading
