// The order in which POV-Ray asks objects (spec 08 A).
#include "tracer/bvh/hierarchy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace verisim::accel {
namespace {

scene::Bounds box(float low_x, float low_y, float low_z, float size) {
  return {{low_x, low_y, low_z}, {size, size, size}};
}

// Entries in the order in which a ray along +z asks them; `depth` of each is what it finds.
std::vector<std::uint32_t> active(const std::vector<Hierarchy::Item>& items, const std::vector<double>& depth) {
  const Hierarchy hierarchy(items);
  std::vector<std::uint32_t> order;
  double best = 1e7;
  hierarchy.search({{0.5, 0.5, -10}, {0, 0, 1}}, best, [&](std::uint32_t entry) {
    order.push_back(entry);
    return best = std::min(best, depth[entry]);
  });
  return order;
}

using Order = std::vector<std::uint32_t>;

TEST(Hierarchy, InfiniteEntriesComeFirstThenTheNearestBox) {
  EXPECT_EQ(active({{0, box(0, 0, 5, 1), false}, {1, box(0, 0, 0, 1), false}, {2, {}, true}}, {1e7, 1e7, 1e7}),
            (Order{2, 1, 0}));
}

TEST(Hierarchy, TheSearchEndsAtAKeyBeyondTheBestDepth) {
  EXPECT_EQ(
      active({{0, box(0, 0, 5, 1), false}, {1, box(0, 0, 0, 1), false}, {2, box(0, 0, 9, 1), false}}, {15, 10, 19}),
      (Order{1}));
}

TEST(Hierarchy, AnEqualKeyIsStillAsked) {
  const Order order =
      active({{0, box(0, 0, 0, 1), false}, {1, box(0, 0, 0, 2), false}, {2, box(0, 0, 5, 1), false}}, {10, 10, 15});
  EXPECT_EQ(order.size(), 2u);
}

TEST(Hierarchy, BoxesBesideOrBehindTheRayAreNotAsked) {
  EXPECT_EQ(active({{0, box(3, 0, 0, 1), false}, {1, box(0, 0, -20, 1), false}, {2, box(0, 0, 0, 1), false}},
                   {1e7, 1e7, 1e7}),
            (Order{2}));
}

TEST(Hierarchy, EveryBoxOnTheWayIsAskedFromNearToFar) {
  for (const std::uint32_t count : {40u, 5000u}) {  // few and many, which are sorted in two ways
    std::vector<Hierarchy::Item> items;
    const auto place = [&](std::uint32_t i) { return static_cast<float>(i * 7 % count) - 5; };
    for (std::uint32_t i = 0; i < count; ++i) items.push_back({i, box(0, 0, place(i), 1), false});
    const Order order = active(items, std::vector<double>(count, 1e7));
    ASSERT_EQ(order.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(items[order[k]].bounds.low[2], static_cast<float>(k) - 5);
  }
}

// Hits of a few entries, some of them in the faces of their boxes, some at equal distances: what a whole search leaves.
TEST(Hierarchy, SettlesAsASearchDoes) {
  std::mt19937 random(5);
  const auto number = [&](int n) { return static_cast<float>(random() % static_cast<unsigned>(n)); };
  std::vector<Hierarchy::Item> items;
  for (std::uint32_t i = 0; i < 400; ++i)
    items.push_back({i, box(number(8) / 4 - 1, number(8) / 4 - 1, number(40) / 4 - 5, 0.25f + number(4) / 2), i == 7});
  Hierarchy hierarchy(items);
  hierarchy.find_parents();
  int settled = 0;
  for (int round = 0; round < 3000; ++round) {
    const Vec3 direction(number(5) * 0.01, number(5) * 0.01, 1);
    const Ray ray{{0.5 - number(3) * 0.1, 0.5, -10 - number(2)}, direction};
    std::vector<Hierarchy::Found> hits;
    for (std::uint32_t entry = 0; entry < items.size(); ++entry)
      if (number(60) == 0) hits.push_back({entry, 8 + number(16) / 4});
    if (hits.size() < 2) continue;
    const double best = round % 4 == 0 ? 9.5 : HUGE_VAL;
    std::size_t expected = hits.size();
    double nearest = best;
    std::vector<bool> reached(items.size());
    hierarchy.search(ray, best, [&](std::uint32_t entry) {
      for (std::size_t i = 0; i < hits.size(); ++i)
        if (hits[i].entry == entry && hits[i].t < nearest) nearest = hits[i].t, expected = i;
      return nearest;
    });
    hierarchy.search(ray, HUGE_VAL, [&](std::uint32_t entry) {
      reached[entry] = true;
      return HUGE_VAL;
    });
    ASSERT_EQ(hierarchy.settle(ray, best, hits), expected) << round;
    for (std::uint32_t entry = 0; entry < items.size(); ++entry)
      ASSERT_EQ(hierarchy.reaches(ray, entry), reached[entry]) << round << ' ' << entry;
    settled += expected < hits.size();
  }
  EXPECT_GT(settled, 500);
}

}  // namespace
}  // namespace verisim::accel
