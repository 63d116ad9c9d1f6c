// Jitter and lens positions against the numbers of spec 02.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tracer/render/sampling/focal_blur.h"
#include "tracer/render/sampling/jitter.h"

namespace verisim::render {
namespace {

TEST(Jitter, PermutationStartsAsInTheSpecification) {
  const int expected[] = {2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(permutation()[i], expected[i]);
}

TEST(Jitter, CheckValues) {
  const auto near = [](double x, double y, double a, double b) {
    const Vec2 j = jitter2(x, y);
    EXPECT_EQ(j.x, static_cast<float>(a))
        << x << ' ' << y;  // the table is of single precision: seen in the far checks of lens rays
    EXPECT_EQ(j.y, static_cast<float>(b)) << x << ' ' << y;
  };
  near(0, 0, 0.084015, 0.084015);
  near(1.5, 2.25, -0.306641, -0.197235);
  near(100.25, 60.75, 0.394562, 0.246124);
  near(-1.0 / 3, 5, -0.417938, -0.173798);
}

TEST(FocalBlur, LensPositionsLieOnTheLensAndDiffer) {
  for (int n : {1, 4, 7, 8, 19, 30, 37, 50, 200}) {
    scene::Camera camera;
    camera.aperture = 1, camera.blur_samples = n;
    const FocalBlur blur(camera, nullptr);
    ASSERT_EQ(blur.positions().size(), static_cast<std::size_t>(n));
    for (const Vec2& p : blur.positions()) EXPECT_LE(p.x * p.x + p.y * p.y, 0.2501);
    EXPECT_NEAR(blur.lens_jitter(),
                n == 7    ? 0.144338
                : n == 19 ? 0.096225
                : n == 37 ? 0.0721688
                          : 0.5 / std::sqrt(n),
                1e-12);
  }
}

// Vectors have no value of their own at first: what lies where the lens is made must not count.
TEST(FocalBlur, LensIsAsSmallAsItsAperture) {
  scene::Camera camera;
  camera.aperture = 0.5, camera.blur_samples = 128;
  std::vector<double> room(sizeof(FocalBlur) / sizeof(double) + 2, 1e3);
  FocalBlur* const blur = std::construct_at(reinterpret_cast<FocalBlur*>(room.data()), camera, nullptr);
  const Vec3 size = blur->lens().max - blur->lens().min;
  EXPECT_LE(std::max({size.x, size.y, size.z}), 0.5);
  EXPECT_GE(std::max({size.x, size.y, size.z}), 0.25);
  std::destroy_at(blur);
}

}  // namespace
}  // namespace verisim::render
