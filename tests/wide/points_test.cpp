// Textures, densities and lights of many points at once are those of each point alone, to the last bit.
#include <gtest/gtest.h>

#include <random>

#include "tests/wide/harness.h"
#include "tracer/functions/function.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/media/media.h"
#include "tracer/noise/noise.h"
#include "tracer/textures/point_batch.h"
#include "tracer/textures/texture.h"

namespace verisim::test {
namespace {

using textures::PointBatch, textures::SurfacePoint;

// Points as they lie in a picture: neighbours, close together or far apart, some of them beyond all lattices.
class RandomPoints {
 public:
  explicit RandomPoints(int round) : random_(static_cast<unsigned>(round)), count(1 + round * 13 % PointBatch::kMax) {
    const double step = std::pow(10.0, round % 5 - 3 + (round == 11 ? 12 : 0));
    const Vec3 from = vector(3), along = vector(step);
    for (int i = 0; i < count; ++i) {
      points.set(i, round % 4 == 3 ? vector(2) : from + static_cast<double>(i) * along);
      together[i].point = points.at(i), together[i].ray_direction = normalize(vector(1));
      together[i].normal = i % 3 == 0 ? Vec3(0, 1, 0) : normalize(vector(1));
      alone[i] = together[i], surfaces[i] = &together[i];
    }
    points.fill_up(count);
  }
  Vec3 vector(double size) { return Vec3(unit_(random_), unit_(random_), unit_(random_)) * size; }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> unit_{-1, 1};

 public:
  const int count;
  PointBatch points;
  SurfacePoint together[PointBatch::kMax], alone[PointBatch::kMax], *surfaces[PointBatch::kMax];
};

void expect_the_same(const textures::CompiledPigment& pigment, int round, Journal& journal) {
  RandomPoints p(round);
  Color colors[PointBatch::kMax], color;
  bool colored[PointBatch::kMax];
  textures::evaluate(pigment, p.count, p.points, p.surfaces, colors, colored);
  for (int i = 0; i < p.count; ++i) {
    ASSERT_EQ(colored[i], textures::evaluate(pigment, p.points.at(i), &p.alone[i], color)) << round << ' ' << i;
    ASSERT_EQ(colors[i], color) << round << ' ' << i << " of " << p.count;
    journal.add(color.r), journal.add(color.g), journal.add(color.b), journal.add(color.f), journal.add(color.t);
  }
}

// Of those that need no surface.
void expect_the_same(const Function& function, int round, Journal& journal) {
  RandomPoints p(round);
  const std::size_t count = round % 3 == 0 ? 65 : static_cast<std::size_t>(p.count), stride = count + 3;
  std::vector<double> points(3 * stride), values(5 * stride);
  for (double& x : points) x = p.vector(3).x;
  function.evaluate_batch(points.data(), stride, count, values.data());
  for (std::size_t k = 0; k < count; ++k) {
    const double at[3] = {points[k], points[stride + k], points[2 * stride + k]};
    double single[5] = {};
    function.evaluate(at, single);
    for (std::size_t c = 0; c < static_cast<std::size_t>(function.components()); ++c) {
      ASSERT_TRUE(same_bits(values[c * stride + k], single[c])) << k << " of " << count;
      journal.add(single[c]);
    }
  }
}

TEST(WidePoints, HaveThePigmentsAndFunctionsOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    const SdlTables tables("points.sdl");
    textures::Compiler compiler{textures::Settings{}};
    for (const auto& [name, pattern] : tables["patterns"]) {
      const bool has_list = pattern.find("Dark") != std::string::npos || pattern.starts_with("image_map");
      const bool needs_surface = pattern.starts_with("slope") || pattern == "aoi";
      for (const auto& [written, modifiers] : tables["modifiers"]) {
        const std::size_t end = modifiers.find(' ');
        const std::string map = has_list ? "" : modifiers.substr(0, end) + "()",
                          sdl = pattern + ' ' + map + (end < modifiers.size() ? modifiers.substr(end) : "");
        SCOPED_TRACE(sdl);
        journal.begin(sdl);
        const scene::Scene scene = tables.scene("sphere { 0, 1 pigment { " + sdl + " } }");
        const scene::PigmentPtr& pigment = scene.objects.at(0)->texture->layers.at(0).pigment;
        const FunctionPtr function = textures::pigment_function(pigment, textures::Settings{});
        for (int round = 0; round < 12; ++round) {
          expect_the_same(*compiler.pigment(pigment), round, journal);
          if (!needs_surface && round < 6) expect_the_same(*function, round, journal);
        }
      }
    }
  });
}

TEST(WidePoints, HaveTheNormalsOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    const SdlTables tables("points.sdl");
    for (const auto& [name, pattern] : tables["normals"]) {
      for (const auto& [written, modifiers] : tables["normal modifiers"]) {
        if (pattern.find("map") != std::string::npos && modifiers.find("map") != std::string::npos) continue;
        SCOPED_TRACE(pattern + ' ' + modifiers);
        journal.begin(pattern + ' ' + modifiers);
        const scene::Scene scene =
            tables.scene("sphere { 0, 1 pigment { Dark } normal { " + pattern + ' ' + modifiers + " } }");
        textures::Compiler compiler{textures::Settings{}};
        const textures::CompiledNormal& normal = *compiler.normal(scene.objects.at(0)->texture->layers.at(0).normal);
        for (int round = 0; round < 10; ++round) {
          RandomPoints p(round);
          Vec3 normals[PointBatch::kMax], before[PointBatch::kMax];
          for (int i = 0; i < p.count; ++i) normals[i] = before[i] = p.alone[i].normal;
          textures::perturb(normal, p.count, p.points, p.surfaces, normals);
          for (int i = 0; i < p.count; ++i) {
            const Vec3 alone = textures::perturb(normal, p.points.at(i), before[i], p.alone[i]);
            ASSERT_TRUE(same_bits(normals[i], alone)) << round << ' ' << i << " of " << p.count;
            ASSERT_TRUE(same_bits(p.together[i].normal, p.alone[i].normal)) << round << ' ' << i << " of " << p.count;
            journal.add(alone);
          }
        }
      }
    }
  });
}

TEST(WidePoints, HaveTheDensitiesOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    const SdlTables tables("points.sdl");
    journal.begin("densities");
    const scene::Scene scene = tables.scene("media { " + tables["densities"][0].sdl + " }");
    textures::Compiler compiler{textures::Settings{}};
    const global::CompiledMedia media = global::compile_media(scene.atmosphere.at(0), compiler);
    int none = 0, some = 0;
    for (int round = 0; round < 200; ++round) {
      const RandomPoints p(round);
      textures::RgbBatch found;
      global::media_densities(media, p.count, p.points, found);
      for (int i = 0; i < p.count; ++i) {
        Rgb product(1.0f);  // nothing left out
        for (const textures::CompiledPigment* density : media.densities) {
          Color color;
          textures::evaluate(*density, p.points.at(i), nullptr, color);
          product *= color.rgb();
        }
        ASSERT_EQ(Rgb(found.r[i], found.g[i], found.b[i]), product) << round << ' ' << i;
        ASSERT_EQ(global::media_density(media, p.points.at(i)), product) << round << ' ' << i;
        journal.add(product.g);
        ++(product == Rgb() ? none : some);
      }
    }
    EXPECT_GT(std::min(none, some), 1000);
  });
}

TEST(WidePoints, AreLitAsEachPointIs) {
  with_each_instruction_set([](Journal& journal) {
    const SdlTables tables("pictures.sdl");
    const auto rays = std::make_unique<RayBatch>();
    const auto places = std::make_unique<shading::GridPlaces>();
    double distance[RayBatch::kSize], attenuation[RayBatch::kSize];
    int kinds[3] = {};  // dark, dim, bright
    for (const auto& [name, sdl] : tables["lights"]) {
      SCOPED_TRACE(name);
      journal.begin(name);
      const scene::Scene scene = tables.scene("light_source { <2,6,-1>, <1,.8,.6> " + sdl + " }");
      const shading::Light light(*std::get<scene::Boxed<scene::LightSource>>(scene.objects.at(0)->shape), true);
      const auto falloff = shading::LightFalloff::of(light);
      for (int round = 0; round < 60; ++round) {
        RandomPoints p(round);
        for (int i = 0; i < p.count; ++i) rays->origin.set(i, p.vector(9)), places->u[i] = p.vector(5).x;
        for (int i = 0; i < p.count; ++i) places->v[i] = p.vector(5).x;
        shading::aim_at(light, p.count, *rays, distance);
        if (falloff) falloff->attenuate(rays->direction, distance, p.count, attenuation);
        for (int i = 0; i < p.count; ++i) {
          const shading::LightDirection alone = light.direction(rays->origin.at(i));
          ASSERT_TRUE(rays->direction.at(i) == alone.towards && distance[i] == alone.distance) << round << ' ' << i;
          const double left = light.attenuation(rays->origin.at(i), alone);
          ASSERT_EQ(falloff ? attenuation[i] : left, left) << round << ' ' << i;
          journal.add(alone.towards), journal.add(alone.distance), journal.add(left);
          ++kinds[falloff && left > 0 ? 1 + (left == 1) : 0];
        }
        const Vec3 from = rays->origin.at(0);
        const shading::Light::Axes axes = light.axes(rays->direction.at(0));
        shading::aim_at_grid(light, axes, from, *places, p.count, *rays, distance);
        for (int i = 0; i < p.count; ++i) {
          const auto alone = light.direction(from, light.offset(axes, places->u[i], places->v[i]));
          ASSERT_TRUE(rays->direction.at(i) == alone.towards && distance[i] == alone.distance) << round << ' ' << i;
        }
      }
    }
    for (const int found : kinds) EXPECT_GT(found, 1000);
  });
}

TEST(WidePoints, HaveTheTurbulenceOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    const textures::Octaves octaves[] = {{6, 2, 0.5}, {10, 2.17, 0.63}, {1, 3, 0.1}};
    for (int round = 0; round < 60; ++round) {
      journal.begin("round " + std::to_string(round));
      const RandomPoints p(round);
      alignas(64) double values[PointBatch::kMax];
      textures::turbulence(1 + round % 3, p.count, p.points, octaves[round / 3 % 3], values);
      for (int i = 0; i < p.count; ++i) {
        const double alone = textures::turbulence(p.points.at(i), octaves[round / 3 % 3], 1 + round % 3);
        ASSERT_EQ(values[i], alone) << round << ' ' << i;
        journal.add(alone);
      }
    }
  });
}

}  // namespace
}  // namespace verisim::test
