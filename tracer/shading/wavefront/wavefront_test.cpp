#include "tracer/shading/wavefront/wavefront.h"

#include <gtest/gtest.h>

namespace verisim::shading {
namespace {

// What wavefronts show is compared in tests/wide/pictures_test.cpp.
TEST(Wavefront, IsNotForReplay) {
  const scene::Scene scene;
  textures::Compiler compiler{textures::Settings{}};
  const accel::World world(scene, compiler);
  const SceneData data(scene, world, compiler, 9, false);
  Tracer replay(data, RandomSource(true, 0)), together(data, RandomSource(false, 0));
  EXPECT_FALSE(Wavefront(replay).usable());
  EXPECT_TRUE(Wavefront(together).usable());
}

}  // namespace
}  // namespace verisim::shading
