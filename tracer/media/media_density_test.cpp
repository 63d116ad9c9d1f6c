// Densities of media: rows have the bits of single points, whichever of the densities are zero.
#include <gtest/gtest.h>

#include "tracer/media/media.h"

namespace verisim::global {
namespace media_density_test {

using enum scene::PatternKind;

scene::DensityPtr density(scene::PatternKind kind, float end_of_zero, double size) {
  scene::Density d;
  d.pattern.kind = kind;
  d.pattern.prepend(Transform::scaling(Vec3(size, size, size)));
  d.color_map = std::make_shared<const scene::ColorMap>(
      scene::ColorMap{{0, Color(0, 0, 0)}, {end_of_zero, Color(0, 0, 0)}, {1, Color(0.9f, 0.7f, 0.3f)}});
  return std::make_shared<const scene::Density>(d);
}

// The product as it is written, nothing left out.
Rgb product(const CompiledMedia& m, const Vec3& p) {
  Rgb value(1.0f);
  for (const textures::CompiledPigment* d : m.densities) {
    Color c;
    textures::evaluate(*d, p, nullptr, c);
    value *= c.rgb();
  }
  return value;
}

TEST(MediaDensity, OfRowsIsTheProductOfAllDensities) {
  textures::Compiler compiler{textures::Settings{}};
  scene::Media description;
  description.densities = {density(wrinkles, 0.45f, 2), density(spherical, 0.2f, 6), density(bozo, 0.4f, 0.7),
                           density(granite, 0.3f, 3)};
  const CompiledMedia media = compile_media(description, compiler);
  int none = 0, some = 0;
  for (int round = 0; round < 200; ++round) {
    const int count = 1 + (round * 7) % textures::PointBatch::kMax;
    const Vec3 from(-3 + 0.03 * round, 0.4 - 0.01 * round, 0.2), along(0.13, 0.01, -0.02);
    textures::PointBatch points;
    for (int i = 0; i < count; ++i) points.set(i, from + static_cast<double>(i) * along);
    points.fill_up(count);
    textures::RgbBatch densities;
    media_densities(media, count, points, densities);
    for (int i = 0; i < count; ++i) {
      const Rgb expected = product(media, points.at(i));
      ASSERT_EQ(Rgb(densities.r[i], densities.g[i], densities.b[i]), expected) << round << ' ' << i;
      ASSERT_EQ(media_density(media, points.at(i)), expected) << round << ' ' << i;
      ++(expected == Rgb() ? none : some);
    }
  }
  EXPECT_GT(none, 100);
  EXPECT_GT(some, 100);
}

TEST(MediaDensity, IsAskedForCheapestFirst) {
  textures::Compiler compiler{textures::Settings{}};
  scene::Media description;
  description.densities = {density(wrinkles, 0.4f, 1), density(crackle, 0.4f, 1), density(granite, 0.4f, 1),
                           density(spherical, 0.4f, 1)};
  EXPECT_EQ(compile_media(description, compiler).by_cost, (std::vector<std::size_t>{3, 2, 1, 0}));
}

}  // namespace media_density_test
}  // namespace verisim::global
