#include "tracer/shapes/swept/outline_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace verisim::shapes {
namespace {

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

std::vector<std::size_t> found(const OutlineIndex& index, const Rectangle& r) {
  std::vector<std::size_t> result;
  index.overlapping(r, [&](std::size_t i) { result.push_back(i); });
  return result;
}

class RandomRectangles {
 public:
  Rectangle next(double most) {
    const Vec2 corner(place_(random_), place_(random_));
    return Rectangle(corner, corner + Vec2(std::fabs(place_(random_)), std::fabs(place_(random_))) * most);
  }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> place_{-3, 3};
};

TEST(OutlineIndex, FindsEveryPieceThatOverlapsInOrderAndLeavesOutMostOthers) {
  RandomRectangles random;
  for (const std::size_t count : {1u, 7u, 64u, 65u, 200u}) {
    std::vector<Rectangle> pieces;
    for (std::size_t i = 0; i < count; ++i) pieces.push_back(random.next(0.1));
    const OutlineIndex index(pieces);
    std::size_t expected = 0, visited = 0;
    for (int query = 0; query < 1000; ++query) {
      const Rectangle r = random.next(query % 3 == 0 ? 0 : 0.3);
      const std::vector<std::size_t> got = found(index, r);
      EXPECT_TRUE(std::is_sorted(got.begin(), got.end()));
      for (std::size_t i = 0; i < count; ++i) {
        if (!overlap(pieces[i], r)) continue;
        ++expected;
        EXPECT_TRUE(std::binary_search(got.begin(), got.end(), i)) << "piece " << i << " of " << count;
      }
      visited += got.size();
    }
    if (count >= 64) {
      EXPECT_LT(visited, 4 * expected + 1000 * count / 20);
    }
  }
}

TEST(OutlineIndex, NumbersThatAreNoneMeanEverything) {
  const std::vector<Rectangle> pieces{Rectangle(Vec2(0), Vec2(1)), Rectangle(Vec2(5), Vec2(6))};
  const OutlineIndex index(pieces);
  EXPECT_EQ(found(index, Rectangle(Vec2(NAN), Vec2(NAN))).size(), 2u);
  EXPECT_EQ(found(index, Rectangle(Vec2(-HUGE_VAL), Vec2(HUGE_VAL))).size(), 2u);
}

TEST(OutlineIndex, OutlinesWithoutSizeOrWithoutEndAreFound) {
  const std::vector<Rectangle> point{Rectangle(Vec2(2), Vec2(2))},
      endless{Rectangle(Vec2(-HUGE_VAL), Vec2(HUGE_VAL)), Rectangle(Vec2(0), Vec2(1))};
  EXPECT_EQ(found(OutlineIndex(point), Rectangle(Vec2(1), Vec2(3))).size(), 1u);
  EXPECT_EQ(found(OutlineIndex(endless), Rectangle(Vec2(0.5), Vec2(0.5))).size(), 2u);
  EXPECT_TRUE(found(OutlineIndex(), Rectangle(Vec2(1), Vec2(3))).empty());
}

}  // namespace
}  // namespace verisim::shapes
