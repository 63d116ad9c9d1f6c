#include "compare/causes/moved_light.h"

#include <gtest/gtest.h>

namespace verisim::compare {
namespace {

constexpr int kSide = 40;

// A ball of radius 1 around the origin, seen along z.
SeenSurfaces ball() {
  SeenSurfaces out;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double u = (x + 0.5) / kSide * 2 - 1, v = 1 - (y + 0.5) / kSide * 2, w = 1 - u * u - v * v;
      const Pixel p =
          w > 0 ? Pixel{static_cast<float>(u), static_cast<float>(v), static_cast<float>(-std::sqrt(w))} : Pixel{};
      out.point.push_back(p), out.normal.push_back(p);
      out.diffuse.push_back(w > 0 ? Pixel{0.8f, 0.5f, 0.2f + 0.01f * static_cast<float>(x)} : Pixel{});
    }
  return out;
}

// What a light of that colour makes of it; nothing in the columns from `dark` on, eight of them.
Pixels lit(const SeenSurfaces& seen, const Vec3& at, int dark) {
  constexpr float kColor[3] = {0.9f, 0.8f, 0.7f};
  Pixels out(seen.point.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int x = static_cast<int>(i) % kSide;
    if (seen.normal[i] == Pixel{} || (x >= dark && x < dark + 8)) continue;
    const Vec3 point(seen.point[i][0], seen.point[i][1], seen.point[i][2]), to = at - point;
    const double facing = std::max(0.0, dot(to, point) / verisim::length(to));
    for (std::size_t k = 0; k < 3; ++k) out[i][k] = seen.diffuse[i][k] * kColor[k] * static_cast<float>(facing);
  }
  return out;
}

TEST(MovedLight, IsFoundThoughItsShadowsMoveToo) {
  const SeenSurfaces seen = ball();
  const Vec3 from(3, 4, -5);
  for (const Vec3& to : {Vec3(1, 4, -5), Vec3(5, 4, -5), Vec3(3, 2, -6)}) {
    const auto found = moved_light(from, lit(seen, from, 10), lit(seen, to, 20), seen);
    ASSERT_TRUE(found);
    EXPECT_LT(verisim::length(normalize(found->position) - normalize(to)), 0.02) << found->position;
    const Pixels wanted = lit(seen, to, 20);
    double left = 0, all = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      left += squared_distance(wanted[i], found->light[i]), all += squared_distance(wanted[i], {});
    EXPECT_LT(left, 0.01 * all);
  }
}

TEST(MovedLight, OtherShadowsAreNoMovement) {
  const SeenSurfaces seen = ball();
  const Vec3 from(3, 4, -5);
  const Pixels light = lit(seen, from, 10);
  EXPECT_FALSE(moved_light(from, light, lit(seen, from, 25), seen));
  EXPECT_FALSE(moved_light(from, light, light, seen));
}

TEST(MovedLight, FewSurfacesTellNothing) {
  SeenSurfaces seen = ball();
  const Pixels light = lit(seen, Vec3(3, 4, -5), 10), other = lit(seen, Vec3(1, 4, -5), 10);
  for (std::size_t i = 0; i < seen.normal.size(); ++i)
    if (i % 20 != 0) seen.normal[i] = {};
  EXPECT_FALSE(moved_light(Vec3(3, 4, -5), light, other, seen));
}

}  // namespace
}  // namespace verisim::compare
