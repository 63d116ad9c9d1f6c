// The order in which POV-Ray asks objects (spec 08 A).
#include "tracer/bvh/hierarchy.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace verisim::accel
