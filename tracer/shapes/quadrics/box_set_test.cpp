// Of boxes that are tested eight at a time none is left out that one test finds.
#include "tracer/shapes/quadrics/box_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tracer/bvh/bvh.h"

namespace verisim::shapes {
namespace {

TEST(BoxSet, FindsTheBoxesOfARayAndOfAPoint) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto anywhere = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  int met = 0, missed = 0, around = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Box3> boxes(1 + static_cast<std::size_t>(round) % BoxSet::kMax);
    for (Box3& box : boxes) {
      const Vec3 middle = anywhere(),
                 half = Vec3(std::fabs(unit(random)), std::fabs(unit(random)), std::fabs(unit(random))) * 0.3;
      box = {middle - half, middle + (round % 7 == 0 ? -half : half)};  // some are flat points
    }
    const BoxSet set(boxes);
    Ray ray;
    ray.origin = anywhere(), ray.direction = normalize(boxes[0].min + anywhere() * 0.2 - ray.origin);
    if (round % 3 == 0) ray.direction[round / 3 % 3] = 0;
    if (round % 5 == 0) ray.origin = boxes[0].min, ray.direction = {0, 0, 1};  // along a face
    const double t_min = round % 4 == 0 ? 0.5 : 0, t_max = round % 6 == 0 ? 1.5 : 2e10;
    const std::uint32_t found = set.meet(ray, t_min, t_max), here = set.around(ray.origin);
    std::uint32_t visited = 0;
    double last = -1;
    set.traverse(ray, t_min, t_max, [&](std::uint32_t i, double limit) {
      EXPECT_EQ(limit, t_max);
      double near = t_min, far = t_max;
      if (accel::clip_to_box(ray, boxes[i], near, far)) {
        EXPECT_GE(near, last - 1e-4);  // boxes are a little larger than they are
        last = near;
      }
      visited |= std::uint32_t{1} << i;
      return limit;
    });
    ASSERT_EQ(visited, found);
    // Nothing behind a limit that was found, and nothing at all behind the last.
    int more = 0;
    set.traverse(ray, t_min, t_max, [&](std::uint32_t, double) { return ++more, -HUGE_VAL; });
    ASSERT_EQ(more, found != 0);
    std::uint32_t seen = 0;
    ASSERT_FALSE(set.any_along(ray, t_min, t_max, [&](std::uint32_t i) {
      seen |= std::uint32_t{1} << i;
      return false;
    }));
    ASSERT_EQ(seen, found);
    ASSERT_EQ(set.any_along(ray, t_min, t_max, [](std::uint32_t) { return true; }), found != 0);
    if (boxes.size() < 32) {
      ASSERT_EQ(found >> boxes.size(), 0u);
      ASSERT_EQ(here >> boxes.size(), 0u);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      double near = t_min, far = t_max;
      if (accel::clip_to_box(ray, boxes[i], near, far)) {
        ASSERT_TRUE(found >> i & 1) << round << ' ' << i;
        ++met;
      } else {
        missed += !(found >> i & 1);
      }
      if (accel::contains(boxes[i], ray.origin)) {
        ASSERT_TRUE(here >> i & 1);
        ++around;
      }
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(missed, 10000);
  EXPECT_GT(around, 100);
}

}  // namespace
}  // namespace verisim::shapes
