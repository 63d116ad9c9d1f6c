// How many points together are lit is compared in tests/wide/points_test.cpp.
#include "tracer/lights/light_falloff.h"

#include <gtest/gtest.h>

namespace verisim::shading {
namespace {

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
