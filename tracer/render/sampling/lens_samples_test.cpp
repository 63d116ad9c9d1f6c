// Jitter and lens positions against the numbers of spec 02; rays of focal blur together and alone.
#include <gtest/gtest.h>

#include <cmath>

#include "tracer/bvh/bvh.h"
#include "tracer/render/cameras/camera_rays.h"
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

// Rays that are made together are those that are made alone, bit by bit: in a window of a picture, for any number.
TEST(FocalBlur, RaysTogetherAreThoseAlone) {
  scene::Camera camera;
  camera.location = {1.3, -0.7, 2.9}, camera.direction = {0.3, 0.1, 1.1};
  camera.right = {1.2, 0.05, -0.3}, camera.up = {-0.1, 0.9, 0.02};
  camera.aperture = 0.8, camera.focal_distance = 7.3, camera.blur_samples = 50;
  const FocalBlur blur(camera, nullptr);
  for (const WindowPlace window : {WindowPlace{}, WindowPlace{31, 17}}) {
    for (const scene::CameraKind kind : {scene::CameraKind::perspective, scene::CameraKind::orthographic}) {
      camera.kind = kind;
      const CameraRays rays(camera, 160, 120, window);
      for (int count : {1, 7, 8, 61, RayBatch::kMax}) {
        std::vector<Vec2> places;
        std::vector<std::uint32_t> numbers;
        for (int i = 0; i < count; ++i)
          places.emplace_back(3.25 * i + 0.1, 2 * i + 1), numbers.push_back(static_cast<std::uint32_t>(i * 7 % 50));
        const auto together = std::make_unique<RayBatch>();
        blur.rays(rays, places.data(), numbers.data(), count, *together);
        for (int i = 0; i < count; ++i) {
          const Ray alone = blur.ray(rays, places[i].x, places[i].y, static_cast<int>(numbers[i]))->ray;
          EXPECT_EQ(together->at(i).origin, alone.origin) << i;
          EXPECT_TRUE(blur.lens().intersects(alone.origin)) << i;
          EXPECT_EQ(together->at(i).direction, alone.direction) << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace verisim::render
