// Rays that go side by side through media find what each finds alone.
#include "tracer/media/media_batch.h"

#include <gtest/gtest.h>

#include <random>

#include "tracer/effects/scene_effects.h"
#include "tracer/shapes/test_support.h"

namespace verisim::global {
namespace {

using shapes::testing::make;

scene::LightSource light_at(const Vec3& position) {
  scene::LightSource light;
  light.position = position, light.color = Rgb(3, 2, 1);
  return light;
}

void add(scene::Scene& scene, const scene::ObjectPtr& object) { scene.objects.push_back(object); }

// Opaque and, if wanted, clear balls; a light that fades, a spot light, and one that shines everywhere.
scene::Scene lit_scene(bool clear_balls) {
  scene::Scene scene;
  scene::LightSource fading = light_at({4, 7, -3}), spot = light_at({-5, 6, 0}), far = light_at({0, 40, 9});
  fading.fade_power = 2, fading.fade_distance = 5;
  spot.kind = scene::LightKind::spotlight, spot.direction = normalize(Vec3(5, -6, 1)), spot.radius = 8,
  spot.falloff = 16, spot.tightness = 2;
  far.color = Rgb(0.3f, 0.4f, 0.5f);
  for (const auto& light : {fading, spot, far}) add(scene, make(scene::Boxed<scene::LightSource>(light)));
  for (int i = 0; i < 14; ++i) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->pattern.kind = scene::PatternKind::plain;
    pigment->color = clear_balls && i % 2 == 0 ? Color(0.9f, 0.5f, 0.7f, 0.8f, 0) : Color(0.5f, 0.5f, 0.5f);
    auto texture = std::make_shared<scene::Texture>();
    texture->layers.push_back({pigment, nullptr, scene::Finish{}});
    const auto ball = make(scene::Sphere{{std::sin(2.0 * i) * 3, 1.0 + 0.3 * i, std::cos(3.1 * i) * 3}, 0.6});
    ball->texture = texture;
    ball->interior = std::make_shared<scene::Interior>();
    add(scene, ball);
  }
  return scene;
}

scene::Media scattering(int type, double threshold) {
  scene::Media media;
  media.has_scattering = true, media.scattering = Rgb(0.1f, 0.12f, 0.08f), media.scattering_type = type,
  media.eccentricity = 0.6;
  media.absorption = Rgb(0.02f, 0.01f, 0.03f);
  media.aa_threshold = threshold;
  return media;
}
scene::DensityPtr clouds() {
  scene::Density d;
  d.pattern.kind = scene::PatternKind::bozo;
  d.color_map = std::make_shared<const scene::ColorMap>(
      scene::ColorMap{{0, Color(0, 0, 0)}, {0.5f, Color(0, 0, 0)}, {1, Color(1.9f, 1.7f, 2.3f)}});
  return std::make_shared<const scene::Density>(d);
}

// Lights as single rays see them.
class Lights : public MediaEnvironment {
 public:
  Lights(shading::Tracer& tracer, const shading::RayState& ray) : tracer_(tracer), ray_(ray) {
    for (const shading::Light& light : tracer.scene().lights()) sources_.push_back(&light.source());
  }
  double random() override { return tracer_.random().media(); }
  std::span<const scene::LightSource* const> lights() override { return sources_; }
  Rgb illumination(std::size_t light, const Vec3& p, Vec3& to_light) override {
    return tracer_.light_at(tracer_.scene().lights()[light], p, ray_, to_light);
  }

 private:
  shading::Tracer& tracer_;
  const shading::RayState& ray_;
  std::vector<const scene::LightSource*> sources_;
};

struct Counts {
  int rays = 0, together = 0, bright = 0;
};

// Rows of any length with rays of any direction, or of neighbours.
Counts expect_the_same(const scene::Scene& scene, const std::vector<scene::Media>& descriptions) {
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const SceneEffects effects(scene, compiler, 9);
  shading::SceneData data(scene, world, compiler, 9, false);
  if (effects.any()) data.effects = &effects;
  shading::Tracer together(data, shading::RandomSource(false, 5)), alone(data, shading::RandomSource(false, 5));
  std::vector<CompiledMedia> compiled;
  for (const scene::Media& m : descriptions) compiled.push_back(compile_media(m, compiler));
  std::vector<const CompiledMedia*> media;
  for (const CompiledMedia& m : compiled) media.push_back(&m);
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto point = [&] { return Vec3(5 * u(generator), 3 + 3 * u(generator), 5 * u(generator)); };
  Counts counts;
  for (int round = 0; round < 30; ++round) {
    const Vec3 from = point(), to = point();
    std::vector<shading::MediaSegment> rays;
    Color seen;
    for (int i = 0; i <= round % static_cast<int>(MediaBatch::kMaxRays); ++i) {
      const Vec3 end = round % 3 == 0 ? point() : to + 0.02 * i * Vec3(1, 0, 0.5);
      const double distance = i == 7 ? 0 : length(end - from);
      rays.push_back(
          {{from, normalize(end - from)}, distance, nullptr, static_cast<std::uint64_t>(round * 100 + i), &seen});
    }
    shading::RayState state = together.camera_state(rays[0].ray, false);
    Lights environment(together, state);
    MediaBatch batch(together, state, media, environment);
    EXPECT_TRUE(batch.possible());
    MediaResult results[MediaBatch::kMaxRays];
    bool done[MediaBatch::kMaxRays] = {};
    batch.integrate(rays, results, done);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      alone.random().begin(rays[i].key);
      shading::RayState own = alone.camera_state(rays[i].ray, false);
      Lights single(alone, own);
      const MediaResult expected = integrate(media, rays[i].ray, rays[i].length, false, single);
      ++counts.rays;
      if (!done[i]) continue;
      ++counts.together;
      counts.bright += expected.emission.max_abs() > 1e-3f;
      EXPECT_EQ(results[i].emission, expected.emission) << round << ' ' << i;
      EXPECT_EQ(results[i].transmittance, expected.transmittance) << round << ' ' << i;
      if (testing::Test::HasFailure()) return counts;
    }
  }
  return counts;
}

// All but those of no length.
void expect_all_together(const Counts& counts) {
  EXPECT_GT(counts.together, counts.rays * 9 / 10);
  EXPECT_GT(counts.bright, counts.rays / 4);
}

TEST(MediaBatch, ScattersAsSingleRaysDo) {
  for (int type = 1; type <= 5; ++type) {
    SCOPED_TRACE(type);
    expect_all_together(expect_the_same(lit_scene(false), {scattering(type, 0.1)}));
  }
  expect_all_together(expect_the_same(lit_scene(true), {scattering(5, 0.1), scattering(2, 0.3)}));
}

TEST(MediaBatch, RefinesAsSingleRaysDo) {
  for (const int level : {1, 2, 4, 9}) {
    SCOPED_TRACE(level);
    scene::Media media = scattering(1, 0.002);
    media.aa_level = level, media.samples_min = level == 4 ? 21 : 4, media.intervals = level == 9 ? 1 : 3;
    expect_all_together(expect_the_same(lit_scene(level == 2), {media}));
  }
}

TEST(MediaBatch, FollowsDensitiesAsSingleRaysDo) {
  scene::Media cloudy = scattering(4, 0.01), glowing;
  cloudy.densities = {clouds()};
  glowing.emission = Rgb(0.3f, 0.1f, 0.2f), glowing.densities = {clouds(), clouds()}, glowing.intervals = 2;
  expect_all_together(expect_the_same(lit_scene(true), {cloudy}));
  expect_all_together(expect_the_same(lit_scene(false), {cloudy, scattering(2, 0.1), glowing}));
  expect_all_together(expect_the_same(lit_scene(false), {glowing}));
}

// Where lights shine decides on the intervals, also if nothing scatters.
TEST(MediaBatch, DividesRaysAsSingleRaysDo) {
  scene::Scene scene = lit_scene(false);
  std::erase_if(scene.objects, [](const scene::ObjectPtr& object) {
    const auto* light = object->as<scene::LightSource>();
    return light && light->kind != scene::LightKind::spotlight;
  });
  scene::Media glowing;
  glowing.emission = Rgb(0.3f, 0.1f, 0.2f), glowing.densities = {clouds()}, glowing.intervals = 5,
  glowing.samples_min = 1, glowing.aa_level = 1;
  expect_all_together(expect_the_same(scene, {glowing}));
  EXPECT_GT(expect_the_same(scene, {scattering(1, 0.1)}).together, 100);
}

// Rays whose light draws numbers on its way are left to go alone.
TEST(MediaBatch, LeavesRaysThatDrawNumbers) {
  scene::Scene scene = lit_scene(false);
  for (const auto& object : scene.objects) {
    auto* light = const_cast<scene::LightSource*>(object->as<scene::LightSource>());
    if (!light || light->fade_power == 0) continue;
    light->area = light->jitter = true;
    light->axis1 = {1, 0, 0}, light->axis2 = {0, 0, 1}, light->size1 = light->size2 = 3;
  }
  EXPECT_EQ(expect_the_same(scene, {scattering(1, 0.1)}).together, 0);
  // One that draws none is asked for every place of its own.
  for (const auto& object : scene.objects)
    if (auto* light = const_cast<scene::LightSource*>(object->as<scene::LightSource>())) light->jitter = false;
  expect_all_together(expect_the_same(scene, {scattering(1, 0.1)}));
}

// Light that media of the air dim draws numbers there, which count only if the media vary.
TEST(MediaBatch, FollowsLightThatIsDimmedOnItsWay) {
  scene::Scene scene = lit_scene(false);
  for (const auto& object : scene.objects)
    if (auto* light = const_cast<scene::LightSource*>(object->as<scene::LightSource>()))
      light->media_attenuation = true;
  scene.atmosphere = {scattering(2, 0.1)};
  expect_all_together(expect_the_same(scene, scene.atmosphere));
  scene.atmosphere[0].jitter = 0.5;
  EXPECT_EQ(expect_the_same(scene, {scattering(2, 0.1)}).together, 0);
}

TEST(MediaBatch, LeavesRaysWithTooManyPlaces) {
  scene::Media fine = scattering(1, 0.1);
  fine.intervals = 20;
  EXPECT_EQ(expect_the_same(lit_scene(false), {fine}).together, 0);
}

TEST(MediaBatch, IsNotPossibleWhereNumbersAreDrawn) {
  const scene::Scene scene = lit_scene(false);
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const shading::SceneData data(scene, world, compiler, 9, false);
  shading::Tracer tracer(data, shading::RandomSource(false, 5));
  const shading::RayState state = tracer.camera_state({{0, 0, 0}, {0, 0, 1}}, false);
  Lights environment(tracer, state);
  const auto possible = [&](const scene::Media& description) {
    const CompiledMedia media = compile_media(description, compiler);
    const CompiledMedia* list[] = {&media};
    return MediaBatch(tracer, state, list, environment).possible();
  };
  scene::Media media = scattering(1, 0.1);
  EXPECT_TRUE(possible(media));
  media.jitter = 0.5;
  EXPECT_FALSE(possible(media));
  media.jitter = 0, media.method = 2;
  EXPECT_FALSE(possible(media));
}

}  // namespace
}  // namespace verisim::global
