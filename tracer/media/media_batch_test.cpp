// Which rays go side by side through media; what they find there: tests/wide/pictures_test.cpp.
#include "tracer/media/media_batch.h"

#include <gtest/gtest.h>

#include "tracer/effects/scene_effects.h"
#include "tracer/shapes/test_support.h"

namespace verisim::global {
namespace {

struct NoNumbers : MediaEnvironment {
  double random() override { return 0; }
  std::span<const scene::LightSource* const> lights() override { return {}; }
  Rgb illumination(std::size_t, const Vec3&, Vec3&) override { return {}; }
};

// How many of a batch's rays go together; -1: not possible.
int together(const scene::LightSource& light, const scene::Media& description) {
  scene::Scene scene;
  scene.objects.push_back(shapes::testing::make(scene::Boxed<scene::LightSource>(light)));
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const shading::SceneData data(scene, world, compiler, 9, false);
  shading::Tracer tracer(data, shading::RandomSource(false, 5));
  const shading::RayState state = tracer.camera_state({{0, 0, 0}, {0, 0, 1}}, false);
  const CompiledMedia media = compile_media(description, compiler);
  const CompiledMedia* list[] = {&media};
  NoNumbers environment;
  MediaBatch batch(tracer, state, list, environment);
  if (!batch.possible()) return -1;
  std::vector<shading::MediaSegment> rays;
  Color seen;
  for (std::size_t i = 0; i < MediaBatch::kMaxRays; ++i)
    rays.push_back({{{0.1 * static_cast<double>(i), 0, 0}, {0, 0, 1}}, 5, nullptr, i, &seen});
  MediaResult results[MediaBatch::kMaxRays];
  bool done[MediaBatch::kMaxRays] = {};
  batch.integrate(rays, results, done);
  return static_cast<int>(std::count(done, done + MediaBatch::kMaxRays, true));
}

TEST(MediaBatch, TakesRaysThatDrawNoNumbersAndHaveFewPlaces) {
  constexpr int kAll = MediaBatch::kMaxRays;
  scene::LightSource lamp, area;
  lamp.position = {4, 7, -3}, lamp.color = Rgb(3, 2, 1);
  area = lamp;
  area.area = area.jitter = true, area.axis1 = {1, 0, 0}, area.axis2 = {0, 0, 1}, area.size1 = area.size2 = 3;
  scene::Media media;
  media.has_scattering = true, media.scattering = Rgb(0.1f), media.scattering_type = 1;
  EXPECT_EQ(together(lamp, media), kAll);
  EXPECT_EQ(together(area, media), 0);
  area.jitter = false;
  EXPECT_EQ(together(area, media), kAll);
  media.intervals = 20;
  EXPECT_EQ(together(lamp, media), 0);
  media.intervals = 1, media.jitter = 0.5;
  EXPECT_EQ(together(lamp, media), -1);
  media.jitter = 0, media.method = 2;
  EXPECT_EQ(together(lamp, media), -1);
}

}  // namespace
}  // namespace verisim::global
