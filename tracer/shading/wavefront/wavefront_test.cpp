// Rays that are shaded together get the bits of rays that are shaded one by one.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tracer/effects/scene_effects.h"
#include "tracer/math/scaled.h"
#include "tracer/render/sampling/pixel_sampler.h"
#include "tracer/shading/finish.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_batch.h"
#include "tracer/shading/wavefront/wavefront.h"
#include "tracer/shapes/test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shading {
namespace {

// A scene of all kinds of surfaces, lights and finishes that wavefronts know, and some that they leave to others.
scene::Scene mixed_scene(bool foggy = false) {
  using shapes::testing::make;
  scene::Scene scene;
  scene.camera.location = {0, 1.5, -6};
  if (foggy) {
    scene::Fog fog;
    fog.color = Color(0.4f, 0.5f, 0.6f, 0.1f, 0.2f), fog.distance = 12;
    scene.fogs.push_back(fog);
    fog.type = 2, fog.altitude = 1, fog.turbulence.emplace();
    scene.fogs.push_back(fog);
  }
  for (int i = 0; i < 2; ++i) {
    scene::LightSource light;
    light.position = {i * 8.0 - 4, 6, -5};
    light.color = Rgb(0.7f, 0.6f, 0.5f);
    if (i == 1) light.fade_power = 2, light.fade_distance = 9, light.media_attenuation = foggy;
    scene.objects.push_back(make(scene::Boxed<scene::LightSource>(light)));
  }
  const auto add = [&](const auto& shape, const Color& color, const scene::Finish& finish) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->pattern.kind = scene::PatternKind::plain;
    pigment->color = color;
    auto texture = std::make_shared<scene::Texture>();
    texture->layers.push_back({pigment, nullptr, finish});
    const auto object = make(shape);
    object->texture = texture;
    object->interior = std::make_shared<scene::Interior>();
    scene.objects.push_back(object);
  };
  for (int i = 0; i < 12; ++i) {
    scene::Finish finish;
    if (i % 3 == 1) finish.phong = 0.8f, finish.phong_size = static_cast<float>(10 * i);
    if (i % 3 == 2) finish.specular = 0.5f, finish.metallic = i > 6 ? 1.0f : 0.0f;
    if (i == 4) finish.specular = 0.5f;  // both kinds of highlights
    if (i == 6) finish.reflection.maximum = Rgb(0.4f);
    if (i == 2) finish.reflection.maximum = Rgb(1), finish.reflection.fresnel = finish.conserve_energy = true;
    if (i == 10)
      finish.reflection.minimum = Rgb(0.1f, 0.3f, 0.2f), finish.reflection.maximum = Rgb(0.6f),
      finish.reflection.exponent = 1.5f;
    if (i == 5 || i == 10) finish.irid = 0.4f, finish.irid_thickness = 0.3, finish.irid_turbulence = i == 5 ? 0.7 : 0;
    if (i == 11) finish.crand = 0.2f;  // random numbers in mirrors, too
    if (i == 7) finish.diffuse_back = 0.5f;
    if (i == 9 || i == 2) finish.brilliance = 3;
    add(scene::Sphere{{i % 4 * 1.2 - 1.8, 0.4 + i / 4, 0.3 * (i % 3)}, 0.55},
        Color(0.2f + 0.06f * static_cast<float>(i), 0.5f, 0.4f, 0, i == 8 ? 0.5f : 0.0f), finish);
  }
  scene::Finish polished;
  polished.reflection.maximum = Rgb(0.3f);
  add(scene::Plane{{0, 1, 0}, -0.5}, Color(0.6f, 0.6f, 0.5f), polished);

  // Several layers, and several textures: a list, an average, a map.
  const auto patterned = [](scene::PatternKind kind, float lowest, float highest) {
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->pattern.kind = kind;
    pigment->pattern.prepend(Transform::scaling(Vec3(0.3)));
    pigment->color_map = std::make_shared<const scene::ColorMap>(scene::ColorMap{
        {0.2f, Color(0.9f, 0.3f, 0.2f, 0.1f * lowest, lowest)}, {0.7f, Color(0.2f, 0.4f, 0.8f, 0, highest)}});
    return pigment;
  };
  const auto texture_of = [](std::initializer_list<scene::PigmentPtr> layers, bool bumpy) {
    auto texture = std::make_shared<scene::Texture>();
    for (const scene::PigmentPtr& pigment : layers) {
      scene::Finish finish;
      if (texture->layers.empty()) finish.phong = 0.6f;
      auto normal = std::make_shared<scene::Normal>();
      normal->pattern.kind = scene::PatternKind::bumps;
      texture->layers.push_back({pigment, bumpy && !texture->layers.empty() ? normal : nullptr, finish});
    }
    return texture;
  };
  using enum scene::PatternKind;
  const auto opaque = texture_of({patterned(granite, 0, 0)}, false),
             layered =
                 texture_of({patterned(wrinkles, 0, 0), patterned(marble, 0, 0.8f), patterned(bozo, 0.9f, 0)}, true);
  const auto veiled = texture_of({patterned(bozo, 0.6f, 0.3f)}, false);
  for (int i = 0; i < 5; ++i) {
    auto texture = std::make_shared<scene::Texture>();
    texture->pattern.kind = i == 1 ? checker : i == 2 ? average : bozo;
    texture->pattern.prepend(Transform::scaling(Vec3(0.2)));
    texture->texture_map = std::make_shared<const scene::BlendMap<scene::TexturePtr>>(
        scene::BlendMap<scene::TexturePtr>{{0.0f, opaque}, {1.0f, i == 4 ? veiled : layered}});
    const auto object = make(scene::Sphere{{i * 0.9 - 1.8, 2.2, 0.4}, 0.5});
    object->texture = i == 0 ? layered : texture;
    object->interior = std::make_shared<scene::Interior>();
    scene.objects.push_back(object);
  }
  return scene;
}

void expect_the_same_together(const scene::Scene& scene) {
  constexpr int kWidth = 83, kHeight = 61;
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  SceneData data(scene, world, compiler, 9, false);
  const global::SceneEffects effects(scene, compiler, 9);
  if (effects.any()) data.effects = &effects;
  const render::CameraModel camera(scene.camera, kWidth, kHeight, compiler);
  Tracer tracer(data, RandomSource(false, 0)), other(data, RandomSource(false, 0));
  ASSERT_TRUE(Wavefront(tracer).usable());
  render::PixelSampler together(camera, tracer), single(camera, other);
  std::vector<Color> batch(kWidth);
  for (int y = 0; y < kHeight; ++y) {
    together.row(0, y, kWidth, batch.data());
    for (int x = 0; x < kWidth; ++x) {
      const Color expected = single(x, y);
      ASSERT_TRUE(batch[x] == expected) << x << ' ' << y;
    }
  }
  std::mt19937 random{5};
  std::uniform_real_distribution<double> beside(-1.4, 1.4), across(0, kWidth - 1), down(0, kHeight - 1);
  for (int count = 1; count < 3 * Wavefront::kMax; count += 7) {
    const double x = across(random), y = down(random);
    std::vector<Vec2> places;
    for (int i = 0; i < count; ++i) places.emplace_back(x + beside(random), y + beside(random));
    std::vector<Color> colors(places.size());
    together.points(places.data(), count, colors.data());
    for (std::size_t i = 0; i < places.size(); ++i)
      ASSERT_TRUE(colors[i] == single(places[i].x, places[i].y)) << count << ' ' << i;
  }
  EXPECT_EQ(tracer.statistics().shadow_rays, other.statistics().shadow_rays);
  EXPECT_EQ(tracer.statistics().camera_rays, other.statistics().camera_rays);
  EXPECT_EQ(tracer.statistics().reflected_rays, other.statistics().reflected_rays);
  EXPECT_EQ(tracer.statistics().refracted_rays, other.statistics().refracted_rays);
  EXPECT_EQ(tracer.statistics().transmitted_rays, other.statistics().transmitted_rays);
  EXPECT_GT(tracer.statistics().reflected_rays, 1000u);
  EXPECT_EQ(tracer.statistics().samples, other.statistics().samples);
}

// Lenses in front of the mixed scene: one within another, one that reflects totally and has a mirror, a prism of
// colours, a pane without refraction, coloured fading glass, and layers and maps of which some let light through.
scene::Scene glass_scene() {
  using shapes::testing::make;
  scene::Scene scene = mixed_scene();
  scene.settings.max_trace_level = 9;
  const auto add = [&](const auto& shape, float ior, const Color& color, float mirror) {
    auto texture = std::make_shared<scene::Texture>();
    auto pigment = std::make_shared<scene::Pigment>();
    pigment->pattern.kind = scene::PatternKind::plain;
    pigment->color = color;
    scene::Finish finish;
    finish.reflection.maximum = Rgb(mirror), finish.conserve_energy = mirror > 0.2f;
    texture->layers.push_back({pigment, nullptr, finish});
    const auto object = make(shape);
    object->texture = texture;
    object->interior = std::make_shared<scene::Interior>();
    object->interior->ior = ior;
    scene.objects.push_back(object);
    return object->interior;
  };
  const auto outer = add(scene::Sphere{{-1, 1, -2.5}, 0.7}, 1.5f, Color(0.9f, 1, 0.9f, 0.8f, 0.1f), 0.1f);
  outer->fade_distance = 0.5f, outer->fade_power = 2, outer->fade_color = Rgb(0.2f, 0.8f, 0.3f);
  add(scene::Sphere{{-1, 1, -2.5}, 0.4}, 1.1f, Color(1, 1, 1, 0, 0.9f), 0.3f);
  add(scene::Box{{0.2, 0.2, -3}, {1.1, 1.3, -2}}, 2.4f, Color(1, 0.9f, 0.9f, 0.9f, 0), 0.3f);
  add(scene::Sphere{{0.3, 2, -2.5}, 0.4}, 1.4f, Color(1, 1, 1, 0.9f, 0), 0)->dispersion = 1.05f;
  add(scene::Box{{-2, -0.4, -3.2}, {2, 0.4, -3.1}}, 1, Color(0.6f, 0.8f, 1, 0.5f, 0.4f), 0);
  return scene;
}

scene::Media media(const Rgb& emission, double jitter) {
  scene::Media media;
  media.emission = emission, media.absorption = Rgb(0.2f), media.jitter = jitter;
  media.has_scattering = true, media.scattering = Rgb(0.1f);
  return media;
}

// A blob and a mesh whose parts have the textures of the mixed scene's objects, alone and mixed by weights.
scene::Scene shared_surfaces_scene() {
  using shapes::testing::make;
  scene::Scene scene = mixed_scene();
  std::vector<scene::TexturePtr> textures;
  for (const scene::ObjectPtr& object : scene.objects)
    if (object->texture) textures.push_back(object->texture);
  const auto add = [&](const std::shared_ptr<scene::Object>& object) {
    object->texture = textures[0];
    object->interior = std::make_shared<scene::Interior>();
    scene.objects.push_back(object);
  };
  auto blob = std::make_shared<scene::Blob>();
  blob->threshold = 0.4;
  for (std::size_t i = 0; i < 9; ++i) {
    const Vec3 center(-1.6 + 0.4 * static_cast<double>(i), 1.4, -1.5);
    blob->components.push_back({center, center, 0.7, 1, false, {}, i == 4 ? nullptr : textures[i]});
  }
  add(make(std::shared_ptr<const scene::Blob>(blob)));
  auto mesh = std::make_shared<scene::MeshData>();
  mesh->textures = textures;
  const auto count = static_cast<std::int32_t>(textures.size());
  for (std::int32_t i = 0; i < count; ++i) {
    const double x = -2.2 + 0.25 * i;
    scene::MeshTriangle t{};
    for (unsigned k = 0; k < 3; ++k) t.vertex[k] = static_cast<std::uint32_t>(mesh->vertices.size()) + k;
    mesh->vertices.insert(mesh->vertices.end(), {{x, 0.1, -2}, {x + 0.3, 0.1, -2}, {x, 0.7, -2}});
    t.texture = {i, i % 3 == 0 ? -1 : (i + 1) % count, i % 3 == 0 ? -1 : (i + 3) % count};
    mesh->triangles.push_back(t);
  }
  add(make(scene::Mesh{mesh, {}}));
  return scene;
}

TEST(Wavefront, MixesTexturesByWeightsAsSingleRaysDo) { expect_the_same_together(shared_surfaces_scene()); }

TEST(Wavefront, GoesThroughGlassAsSingleRaysDo) { expect_the_same_together(glass_scene()); }

// Each branch of a ray's tree has random numbers of its own, so it does not matter what is traced together.
TEST(Wavefront, DrawsTheRandomNumbersOfSingleRays) {
  scene::Scene scene = glass_scene();
  scene.settings.max_trace_level = 2;
  for (const auto& object : scene.objects) {
    if (!object->interior) continue;
    object->interior->hollow = true;
    object->interior->media.push_back(media(Rgb(0.1f, 0.2f, 0.3f), 0.5));
  }
  expect_the_same_together(scene);
  for (const auto& object : scene.objects) {
    if (auto* light = const_cast<scene::LightSource*>(object->as<scene::LightSource>())) {
      light->area = light->jitter = true;
      light->axis1 = {1, 0, 0}, light->axis2 = {0, 1, 0}, light->size1 = light->size2 = 2;
    }
  }
  expect_the_same_together(scene);
  scene.atmosphere.push_back(media(Rgb(0.01f), 0.3));
  scene::Rainbow rainbow;
  rainbow.direction = {0, 0, 1}, rainbow.angle = 30, rainbow.width = 20, rainbow.distance = 3, rainbow.jitter = 0.1;
  rainbow.colors = std::make_shared<scene::Pigment>();
  scene.rainbows.push_back(rainbow);
  expect_the_same_together(scene);
}

// The opaque things of the mixed scene in a clear hollow ball with scattering media.
scene::Scene scene_in_container(double jitter) {
  scene::Scene scene = mixed_scene();
  std::erase_if(scene.objects, [](const scene::ObjectPtr& object) {
    return object->texture &&
           (object->texture->texture_map || object->texture->layers.size() != 1 ||
            object->texture->layers[0].pigment->color.t > 0 || object->texture->layers[0].pigment->color_map);
  });
  auto texture = std::make_shared<scene::Texture>();
  auto pigment = std::make_shared<scene::Pigment>();
  pigment->pattern.kind = scene::PatternKind::plain;
  pigment->color = Color(1, 1, 1, 0, 1);
  texture->layers.push_back({pigment, nullptr, scene::Finish{}});
  const auto container = shapes::testing::make(scene::Sphere{{0, 0, 0}, 15});
  container->texture = texture;
  container->interior = std::make_shared<scene::Interior>();
  container->interior->hollow = true;
  container->interior->media.push_back(media(Rgb(0.01f), jitter));
  container->interior->media.push_back(media(Rgb(0.02f), jitter));
  container->interior->media.back().intervals = 3, container->interior->media.back().samples_min = 4;
  scene.objects.push_back(container);
  return scene;
}

TEST(Wavefront, SeesMediaOfContainersAsSingleRaysDo) {
  expect_the_same_together(scene_in_container(0));
  expect_the_same_together(scene_in_container(0.5));
}

// Fog and media fill the air; one light is dimmed by both, the other may draw numbers on its way.
TEST(Wavefront, SeesMediaOfTheAirAsSingleRaysDo) {
  for (const bool foggy : {true, false}) {
    for (const double jitter : {0.0, 0.5}) {
      scene::Scene scene = mixed_scene(foggy);
      scene.atmosphere.push_back(media(Rgb(0.01f), jitter));
      expect_the_same_together(scene);
      for (const auto& object : scene.objects) {
        auto* light = const_cast<scene::LightSource*>(object->as<scene::LightSource>());
        if (!light || light->media_attenuation) continue;
        light->area = light->jitter = true;
        light->axis1 = {1, 0, 0}, light->axis2 = {0, 1, 0}, light->size1 = light->size2 = 2;
      }
      expect_the_same_together(scene);
    }
  }
}

// What is found for many points at once is what each finds alone: also beyond the container, where its wall is met.
TEST(Wavefront, LooksForLightInSpace) {
  scene::Scene scene = scene_in_container(0);
  auto tinted = std::make_shared<scene::Texture>(*scene.objects.back()->texture);
  auto pigment = std::make_shared<scene::Pigment>(*tinted->layers[0].pigment);
  pigment->color = Color(0.9f, 0.5f, 0.7f, 0.8f, 0);
  tinted->layers[0].pigment = pigment;
  const_cast<scene::Object&>(*scene.objects.back()).texture = tinted;
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const SceneData data(scene, world, compiler, 9, false);
  Tracer tracer(data, RandomSource(false, 0));
  const RayState eye = tracer.camera_state({{0, 1, -6}, {0, 0, 1}}, false);
  std::mt19937 random{6};
  std::uniform_real_distribution<double> u(-4, 4), far(-40, 40);
  int blocked = 0, open = 0, filtered = 0;
  for (int round = 0; round < 100; ++round) {
    ShadowBatch batch;
    std::vector<Vec3> points;
    for (int i = 0; i <= round % ShadowBatch::kMax; ++i)
      points.push_back(round % 4 == 0 ? Vec3(far(random), far(random), far(random))
                                      : Vec3(u(random), u(random), u(random)));
    for (std::size_t number = 0; number < data.global_lights(); ++number) {
      const Light& light = data.lights()[number];
      batch.count = 0;
      for (const Vec3& p : points) {
        const LightDirection to = light.direction(p);
        batch.add({p, to.towards}, to.distance, scaled(light.color(), light.attenuation(p, to)), nullptr, 0);
      }
      bool known[ShadowBatch::kMax];
      tracer.look_for_light(light, eye, batch, known);
      for (std::size_t i = 0; i < points.size(); ++i) {
        Vec3 to_light;
        const Rgb alone = tracer.light_at(light, points[i], eye, to_light),
                  free = scaled(light.color(), light.attenuation(points[i], light.direction(points[i])));
        ASSERT_TRUE(known[i]);
        if (free.max_abs() < 1e-4f) continue;  // not asked for
        ASSERT_EQ(batch.light[i], alone);
        ++(alone == Rgb() ? blocked : alone == free ? open : filtered);
      }
    }
  }
  EXPECT_GT(blocked, 100);
  EXPECT_GT(open, 100);
  EXPECT_GT(filtered, 100);
}

TEST(Wavefront, GivesTheColoursOfSingleRays) { expect_the_same_together(mixed_scene()); }
TEST(Wavefront, SeesThroughFogAsSingleRaysDo) { expect_the_same_together(mixed_scene(true)); }

// Cameras whose rays are not linear in the position.
TEST(Wavefront, GivesTheColoursOfSingleRaysOfCurvedCameras) {
  using enum scene::CameraKind;
  for (const scene::CameraKind kind : {fisheye, panoramic, ultra_wide_angle}) {
    scene::Scene scene = mixed_scene();
    scene.camera.kind = kind;
    scene.camera.angle = 80;
    SCOPED_TRACE(static_cast<int>(kind));
    expect_the_same_together(scene);
  }
}

// Two rays for each pixel, from the faces of two meshes that look at the scene; the last row has no faces in the
// second.
TEST(Wavefront, GivesTheColoursOfSingleRaysOfFaces) {
  constexpr int kWidth = 83, kHeight = 61;
  scene::Scene scene = mixed_scene();
  scene.camera.kind = scene::CameraKind::mesh_camera;
  scene.camera.rays_per_pixel = 2;
  scene.camera.location = Vec3(0, 0, 0), scene.camera.direction = Vec3(0, 0, 1);
  for (int m = 0; m < 2; ++m) {
    auto mesh = std::make_shared<scene::MeshData>();
    for (int y = 0; y < kHeight - m; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Vec3 p(5.0 * x / kWidth - 2.5, 2.0 - 2.5 * y / kHeight, -6 - m), tilt(0, 0, 0.00002 * x);
        scene::MeshTriangle t{};
        for (unsigned i = 0; i < 3; ++i) t.vertex[i] = static_cast<std::uint32_t>(mesh->vertices.size()) + i;
        mesh->vertices.insert(mesh->vertices.end(), {p, p + Vec3(0, 0.01, 0), p + Vec3(0.01, 0, 0) + tilt});
        mesh->triangles.push_back(t);
      }
    }
    scene.camera.meshes.push_back(mesh);
  }
  expect_the_same_together(scene);
}

// Places all over the picture: where rays of one wavefront enter the world is remembered for all of them at once.
TEST(Wavefront, GivesTheColoursOfSinglePointsFarApart) {
  const scene::Scene scene = mixed_scene();
  constexpr int kWidth = 640, kHeight = 480;
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const SceneData data(scene, world, compiler, 9, false);
  const render::CameraModel camera(scene.camera, kWidth, kHeight, compiler);
  Tracer tracer(data, RandomSource(false, 0)), other(data, RandomSource(false, 0));
  tracer.coherent().set_camera(camera.coherence);
  render::PixelSampler together(camera, tracer), single(camera, other);
  std::mt19937 random{7};
  std::uniform_real_distribution<double> across(-0.5, kWidth - 0.5), down(-0.5, kHeight - 0.5);
  std::vector<Vec2> places;
  for (int i = 0; i < 20 * Wavefront::kMax; ++i) places.emplace_back(across(random), down(random));
  std::vector<Color> colors(places.size());
  together.points(places.data(), static_cast<int>(places.size()), colors.data());
  for (std::size_t i = 0; i < places.size(); ++i) ASSERT_TRUE(colors[i] == single(places[i].x, places[i].y)) << i;
}

// Lens rays of several samples advance in step; each sample ends where it ends alone.
TEST(Wavefront, GivesTheColoursOfSingleLensRays) {
  scene::Scene scene = mixed_scene();
  constexpr int kWidth = 45, kHeight = 31;
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const SceneData data(scene, world, compiler, 9, false);
  for (const double focus : {2.0, 6.0, 40.0}) {
    for (const int samples : {1, 5, 19, 40}) {
      scene.camera.aperture = samples == 5 ? 8 : 0.6;  // the large lens reaches into the things around it
      scene.camera.focal_distance = focus, scene.camera.blur_samples = samples, scene.camera.variance = 1e-3;
      const render::CameraModel camera(scene.camera, kWidth, kHeight, compiler);
      ASSERT_TRUE(camera.linear);
      Tracer tracer(data, RandomSource(false, 0)), other(data, RandomSource(false, 0));
      tracer.coherent().set_camera(camera.coherence);
      render::PixelSampler together(camera, tracer), single(camera, other);
      std::vector<Color> batch(kWidth);
      for (int y = 0; y < kHeight; y += 3) {
        together.row(-0.5, y, kWidth, batch.data());
        for (int x = 0; x < kWidth; ++x)
          ASSERT_TRUE(batch[static_cast<std::size_t>(x)] == single(x - 0.5, y))
              << x << ' ' << y << " focus " << focus << " samples " << samples;
      }
      EXPECT_EQ(tracer.statistics().camera_rays, other.statistics().camera_rays);
      EXPECT_EQ(tracer.statistics().samples, other.statistics().samples);
    }
  }
}

// Radiosity's rays from a place into all directions.
void expect_the_same_gathered(scene::Scene scene, bool volumes) {
  scene.settings.radiosity.adc_bailout = 0.01;
  for (const auto& object : scene.objects)  // which these rays see as a point
    if (auto* light = const_cast<scene::LightSource*>(object->as<scene::LightSource>()))
      light->area = true, light->axis1 = {1, 0, 0}, light->axis2 = {0, 1, 0}, light->size1 = light->size2 = 3;
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  SceneData data(scene, world, compiler, 9, true);
  const global::SceneEffects effects(scene, compiler, 9);
  if (effects.any()) data.effects = &effects;
  Tracer tracer(data, RandomSource(false, 0)), other(data, RandomSource(false, 0));
  const auto wavefront = std::make_unique<Wavefront>(tracer);
  ASSERT_TRUE(wavefront->can_gather());
  RayState state;
  state.primary = false, state.gather = true, state.volumes = volumes, state.weight = 0.5f, state.level = 1,
  state.level_limit = 5, state.gather_depth = 1;
  std::mt19937 random{9};
  std::normal_distribution<double> n;
  int hits = 0;
  for (int count = 1; count <= Wavefront::kMax; ++count) {
    const Vec3 from(0.4 * n(random), 1.2, -1.5 + 0.3 * n(random));
    std::vector<shapes::Hit> hit(static_cast<std::size_t>(count));
    std::vector<FinalGatherNotes> notes(hit.size());
    std::vector<Color> expected(hit.size()), colors(hit.size());
    for (std::size_t i = 0; i < hit.size(); ++i) {
      const Ray ray{from, normalize(Vec3(n(random), n(random), n(random)))};
      const auto key = RandomSource::branch_key(static_cast<RandomSource::Key>(count), RandomBranch::gather(i));
      state.ray = ray;
      const bool found = other.nearest(state, hit[i]);
      hits += found;
      other.random().begin(key);
      expected[i] = other.resolve(state, found ? &hit[i] : nullptr);
      wavefront->add_gathering(ray, key, found ? &hit[i] : nullptr, notes[i]);
    }
    EXPECT_EQ(wavefront->full(), count == Wavefront::kMax);
    wavefront->shade_gathering(state, colors.data());
    for (std::size_t i = 0; i < hit.size(); ++i) ASSERT_TRUE(colors[i] == expected[i]) << count << ' ' << i;
  }
  EXPECT_GT(hits, 300);
  EXPECT_EQ(tracer.statistics().reflected_rays, other.statistics().reflected_rays);
  EXPECT_EQ(tracer.statistics().shadow_rays, other.statistics().shadow_rays);
}

TEST(Wavefront, GathersTheLightOfSingleRays) {
  expect_the_same_gathered(mixed_scene(), true);
  expect_the_same_gathered(mixed_scene(true), false);
  expect_the_same_gathered(mixed_scene(true), true);
  expect_the_same_gathered(glass_scene(), true);
  scene::Scene hazy = mixed_scene();
  hazy.atmosphere.push_back(media(Rgb(0.01f), 0.3));
  expect_the_same_gathered(hazy, true);
  expect_the_same_gathered(hazy, false);
}

TEST(Wavefront, IsNotForReplay) {
  scene::Scene scene = mixed_scene();
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  SceneData data(scene, world, compiler, 9, false);
  Tracer replay(data, RandomSource(true, 0));
  EXPECT_FALSE(Wavefront(replay).usable());
}

}  // namespace
}  // namespace verisim::shading
