// Textures, densities and lights of many points at once are those of each point alone, to the last bit.
#include <gtest/gtest.h>

#include <random>

#include "tests/wide/each_instruction_set.h"
#include "tests/wide/sdl_tables.h"
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

TEST(WidePoints, HaveTheDensitiesAndTurbulenceOfEachPoint) {
  with_each_instruction_set([](Journal& journal) {
    const SdlTables tables("points.sdl");
    journal.begin("densities");
    const scene::Scene scene = tables.scene("media { " + tables["densities"][0].sdl + " }");
    textures::Compiler compiler{textures::Settings{}};
    const global::CompiledMedia media = global::compile_media(scene.atmosphere.at(0), compiler);
    const textures::Octaves octaves[] = {{6, 2, 0.5}, {10, 2.17, 0.63}, {1, 3, 0.1}};
    int none = 0, some = 0;
    for (int round = 0; round < 200; ++round) {
      const RandomPoints p(round);
      textures::RgbBatch found;
      global::media_densities(media, p.count, p.points, found);
      alignas(64) double turbulence[PointBatch::kMax];
      textures::turbulence(1 + round % 3, p.count, p.points, octaves[round / 3 % 3], turbulence);
      for (int i = 0; i < p.count; ++i) {
        const Vec3 at = p.points.at(i);
        Rgb product(1.0f);  // nothing left out
        for (const textures::CompiledPigment* density : media.densities) {
          Color color;
          textures::evaluate(*density, at, nullptr, color);
          product *= color.rgb();
        }
        ASSERT_EQ(Rgb(found.r[i], found.g[i], found.b[i]), product) << round << ' ' << i;
        ASSERT_EQ(global::media_density(media, at), product) << round << ' ' << i;
        ASSERT_EQ(turbulence[i], textures::turbulence(at, octaves[round / 3 % 3], 1 + round % 3)) << round << ' ' << i;
        journal.add(product.g), journal.add(turbulence[i]);
        ++(product == Rgb() ? none : some);
      }
    }
    EXPECT_GT(std::min(none, some), 1000);
  });
}

TEST(WidePoints, AreLitAsEachPointIs) {
  with_each_instruction_set([](Journal& journal) {
    const SdlTables tables("pictures.sdl");
    RayBatch rays;
    shading::GridPlaces places;
    double distance[RayBatch::kSize], left[RayBatch::kSize];
    int kinds[3] = {};  // dark, dim, bright
    for (const auto& [name, sdl] : tables["lights"]) {
      SCOPED_TRACE(name);
      journal.begin(name);
      const scene::Scene scene = tables.scene("light_source { <2,6,-1>, <1,.8,.6> " + sdl + " }");
      const shading::Light light(*std::get<scene::Boxed<scene::LightSource>>(scene.objects.at(0)->shape), true);
      const auto expect = [&](int i, const shading::LightDirection& alone) {
        ASSERT_TRUE(rays.direction.at(i) == alone.towards && distance[i] == alone.distance) << i;
        journal.add(alone.towards), journal.add(alone.distance);
      };
      for (int round = 0; round < 60; ++round) {
        RandomPoints p(round);
        for (int i = 0; i < p.count; ++i) rays.origin.set(i, p.vector(9));
        shading::aim_at(light, p.count, rays, distance);
        shading::LightFalloff::of(light).value().attenuate(rays.direction, distance, p.count, left);
        for (int i = 0; i < p.count; ++i) {
          const Vec3 at = rays.origin.at(i);
          expect(i, light.direction(at));
          ASSERT_EQ(left[i], light.attenuation(at, light.direction(at))) << round << ' ' << i;
          journal.add(left[i]), ++kinds[left[i] > 0 ? 1 + (left[i] == 1) : 0];
        }
        const Vec3 from = rays.origin.at(0);
        const shading::Light::Axes axes = light.axes(rays.direction.at(0));
        for (int i = 0; i < p.count; ++i) places.u[i] = p.vector(5).x, places.v[i] = p.vector(5).y;
        shading::aim_at_grid(light, axes, from, places, p.count, rays, distance);
        for (int i = 0; i < p.count; ++i)
          expect(i, light.direction(from, light.offset(axes, places.u[i], places.v[i])));
      }
    }
    for (const int met : kinds) EXPECT_GT(met, 1000);
  });
}

}  // namespace
}  // namespace verisim::test
