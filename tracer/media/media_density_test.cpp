// What densities are at many points is compared in tests/wide/points_test.cpp.
#include <gtest/gtest.h>

#include "tracer/media/media.h"

namespace verisim::global {
namespace media_density_test {

using enum scene::PatternKind;

TEST(MediaDensity, IsAskedForCheapestFirst) {
  textures::Compiler compiler{textures::Settings{}};
  scene::Media description;
  for (const scene::PatternKind kind : {wrinkles, crackle, granite, spherical}) {
    scene::Density density;
    density.pattern.kind = kind;
    density.color_map = std::make_shared<const scene::ColorMap>(
        scene::ColorMap{{0, Color(0, 0, 0)}, {0.4, Color(0, 0, 0)}, {1, Color(0.9f, 0.7f, 0.3f)}});
    description.densities.push_back(std::make_shared<const scene::Density>(density));
  }
  EXPECT_EQ(compile_media(description, compiler).by_cost, (std::vector<std::size_t>{3, 2, 1, 0}));
}

}  // namespace media_density_test
}  // namespace verisim::global
