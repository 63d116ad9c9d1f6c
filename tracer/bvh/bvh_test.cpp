// Bvh, Shaft and EntryPoints against a test of every box in double precision: nothing may be lost.
#include "tracer/bvh/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tracer/bvh/shaft.h"

namespace verisim::accel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  Vec3 point(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Vec3 in(const Box3& b) { return {(*this)(b.min.x, b.max.x), (*this)(b.min.y, b.max.y), (*this)(b.min.z, b.max.z)}; }
  int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }
};

// Boxes of very different sizes, some flat, some on top of each other, around `center`.
std::vector<Box3> boxes_around(Random& random, const Vec3& center, int count) {
  std::vector<Box3> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = center + random.point(10);
    Vec3 half = random.point(1) * std::pow(10.0, random(-3, 0.3));
    for (int k = 0; k < 3; ++k) half[k] = random.below(8) == 0 ? 0 : std::fabs(half[k]);
    boxes.emplace_back(p - half, p + half);
    if (random.below(10) == 0) boxes.push_back(boxes.back());
  }
  return boxes;
}

// Rays aimed at boxes, at their corners and past everything; along axes and in planes; from inside, near and far away.
Ray ray_at(Random& random, const std::vector<Box3>& boxes, const Vec3& center) {
  const Box3& box = boxes[static_cast<std::size_t>(random.below(static_cast<int>(boxes.size())))];
  Vec3 target = random.in(box);
  if (random.below(4) == 0) target = box.min;
  if (random.below(10) == 0) target = center + random.point(20);
  Vec3 direction = random.point(1);
  for (int k = 0; k < 3; ++k)
    if (random.below(5) == 0) direction[k] = random.below(2) ? 0.0 : -0.0;
  if (length(direction) == 0) direction = {0, 0, -1};
  direction = normalize(direction);
  const double distance = random.below(3) == 0 ? random(0, 5) : random.below(2) ? random(0, 100) : 1e6;
  return {target - distance * direction, direction};
}

std::set<std::uint32_t> met_by_test(const Ray& ray, const std::vector<Box3>& boxes, double t_min, double t_max) {
  std::set<std::uint32_t> met;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    double near = t_min, far = t_max;
    if (clip_to_box(ray, boxes[i], near, far)) met.insert(static_cast<std::uint32_t>(i));
  }
  return met;
}

std::set<std::uint32_t> met_by_tree(const Ray& ray, const Bvh& tree, double t_min, double t_max,
                                    const EntryPoints* entry = nullptr) {
  std::set<std::uint32_t> met;
  if (tree.order().empty()) {
    tree.traverse(
        ray, t_min, t_max,
        [&](std::uint32_t i, double far) {
          EXPECT_TRUE(met.insert(i).second) << "visited twice";
          return far;
        },
        entry);
  } else {
    tree.traverse_leaves(
        ray, t_min, t_max,
        [&](std::uint32_t first, std::uint32_t count, double far) {
          for (std::uint32_t i = first; i < first + count; ++i)
            EXPECT_TRUE(met.insert(tree.order()[i]).second) << "visited twice";
          return far;
        },
        entry);
  }
  return met;
}

Bvh tree_of(const std::vector<Box3>& boxes, unsigned leaf_size) {
  return Bvh(
      boxes.size(), [&](std::size_t i) { return boxes[i]; }, leaf_size);
}

TEST(Bvh, FindsWhatATestOfEveryBoxFinds) {
  Random random(1);
  for (const double offset : {0.0, 1e3, 1e7}) {
    for (const int count : {1, 3, 4, 5, 8, 40, 1500}) {
      const Vec3 center = random.point(offset);
      const auto boxes = boxes_around(random, center, count);
      for (const unsigned leaf_size : {1u, 4u, 8u}) {
        const Bvh tree = tree_of(boxes, leaf_size);
        std::size_t found = 0;
        for (int i = 0; i < 400; ++i) {
          const Ray ray = ray_at(random, boxes, center);
          const double t_min = random.below(2) ? 0 : random(0, 3),
                       t_max = random.below(2) ? kInfinity : t_min + random(0, 50);
          const auto expected = met_by_test(ray, boxes, t_min, t_max), actual = met_by_tree(ray, tree, t_min, t_max);
          ASSERT_TRUE(std::includes(actual.begin(), actual.end(), expected.begin(), expected.end()))
              << offset << ' ' << count << ' ' << leaf_size;
          found += expected.size();
        }
        EXPECT_GT(found, 100u);
      }
    }
  }
}

TEST(Bvh, AllBoxesAlongARayAreThoseThatWalksFind) {
  Random random(3);
  for (const int count : {1, 5, 40, 300}) {
    const auto boxes = boxes_around(random, Vec3(5), count);
    const Bvh tree(boxes);
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
      const Ray ray = ray_at(random, boxes, Vec3(5));
      const double t_min = random.below(2) ? 0 : random(0, 3), t_max = random.below(2) ? 1e7 : t_min + random(0, 50);
      BoxesAlong along;
      ASSERT_TRUE(tree.boxes_along(ray, t_min, t_max, nullptr, along));
      std::set<std::uint32_t> met;
      float before = 0;
      for (const BoxesAlong::Met& box : along.all()) {
        met.insert(box.primitive);
        double near = t_min, far = t_max;
        if (clip_to_box(ray, boxes[box.primitive], near, far)) {
          EXPECT_LE(box.near, near - along.start() + tree.slack());
          EXPECT_GE(box.far, far - along.start() - tree.slack());
        }
        EXPECT_LE(before, box.near);
        before = box.near;
      }
      ASSERT_EQ(met, met_by_tree(ray, tree, t_min, t_max));
      found += met.size();
    }
    EXPECT_GT(found, 100u);
  }
}

TEST(Bvh, MoreBoxesAlongARayThanThereIsRoomForAreRefused) {
  std::vector<Box3> boxes;
  for (int i = 0; i < BoxesAlong::kMax; ++i) boxes.emplace_back(Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1));
  const Ray ray{{-1, 0.5, 0.5}, {1, 0, 0}};
  BoxesAlong along;
  EXPECT_TRUE(Bvh(boxes).boxes_along(ray, 0, 1000, nullptr, along));
  EXPECT_EQ(along.all().size(), boxes.size());
  boxes.emplace_back(Vec3(-0.5, 0, 0), Vec3(-0.2, 1, 1));
  EXPECT_FALSE(Bvh(boxes).boxes_along(ray, 0, 1000, nullptr, along));
}

TEST(Bvh, VisitsFewBoxesAndNoneBeyondTheLimit) {
  Random random(2);
  const auto boxes = boxes_around(random, Vec3(0), 5000);
  const Bvh tree(boxes);
  std::size_t visited = 0, met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = ray_at(random, boxes, Vec3(0));
    met += met_by_test(ray, boxes, 0, kInfinity).size();
    visited += met_by_tree(ray, tree, 0, kInfinity).size();
    // The limit shrinks to the first box met: what lies behind it is left out, and the nearest is among what is
    // visited.
    double nearest = kInfinity;
    for (const Box3& box : boxes) {
      double near = 0, far = kInfinity;
      if (clip_to_box(ray, box, near, far)) nearest = std::min(nearest, near);
    }
    double best = kInfinity;
    tree.traverse(ray, 0, kInfinity, [&](std::uint32_t k, double limit) {
      double near = 0, far = kInfinity;
      if (clip_to_box(ray, boxes[k], near, far)) best = std::min(best, near);
      return std::min(best, limit);
    });
    ASSERT_EQ(best, nearest);
    int calls = 0;
    tree.traverse(ray, 0, kInfinity, [&](std::uint32_t, double) {
      ++calls;
      return -kInfinity;
    });
    ASSERT_LE(calls, 1);
  }
  EXPECT_LT(visited, met + met / 20 + 100) << "boxes are hardly wider than they must be";
}

// How many nodes below one, and itself, have a single child.
std::size_t nodes_of_one(const Bvh& tree, std::uint32_t place) {
  const BoxNode& node = tree.node(place);
  std::size_t children = 0, found = 0;
  for (int k = 0; k < 4; ++k) {
    if (node.planes[0][k] > node.planes[3][k]) continue;
    ++children;
    if (!(node.child[k] & BoxNode::kLeaf)) found += nodes_of_one(tree, node.child[k]);
  }
  return found + (children == 1);
}

TEST(Bvh, LeavesHaveNoNodeOfTheirOwn) {
  Random random(6);
  for (const int count : {5, 40, 1500, 40000}) {
    const auto boxes = boxes_around(random, Vec3(0), count);
    for (const unsigned leaf_size : {1u, 4u, 8u})
      EXPECT_EQ(nodes_of_one(tree_of(boxes, leaf_size), 0), 0u) << count << ' ' << leaf_size;
  }
}

TEST(Bvh, BoxesAroundAPoint) {
  Random random(3);
  for (const double offset : {0.0, 1e5}) {
    const Vec3 center = random.point(offset);
    const auto boxes = boxes_around(random, center, 800);
    const Bvh tree(boxes);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = random.in(boxes[static_cast<std::size_t>(random.below(800))]);
      std::set<std::uint32_t> expected, actual;
      for (std::size_t k = 0; k < boxes.size(); ++k)
        if (contains(boxes[k], p)) expected.insert(static_cast<std::uint32_t>(k));
      tree.any_around(p, [&](std::uint32_t k) {
        actual.insert(k);
        return false;
      });
      ASSERT_TRUE(std::includes(actual.begin(), actual.end(), expected.begin(), expected.end()));
      ASSERT_LE(actual.size(), expected.size() + 20);
    }
  }
}

TEST(Bvh, LeavesOutWhatIsEmptyOrUnbounded) {
  const std::vector<Box3> boxes = {Box3(), Box3(Vec3(-1), Vec3(1)), Box3(Vec3(-kInfinity), Vec3(kInfinity)),
                                   Box3(Vec3(std::nan("")), Vec3(1))};
  const Bvh tree = tree_of(boxes, 4);
  EXPECT_EQ(tree.order(), std::vector<std::uint32_t>{1});
  EXPECT_TRUE(tree_of({Box3()}, 4).empty());
  EXPECT_TRUE(Bvh().empty());
  Bvh().traverse({Vec3(0), {0, 0, 1}}, 0, 1, [](std::uint32_t, double far) {
    ADD_FAILURE();
    return far;
  });
}

TEST(Bvh, HostileNumbersDoNoHarm) {
  Random random(4);
  auto boxes = boxes_around(random, Vec3(0), 300);
  boxes.emplace_back(Vec3(-9e29), Vec3(9e29));
  boxes.emplace_back(Vec3(1e29), Vec3(1e29));
  boxes.insert(boxes.end(), 1000, Box3(Vec3(2), Vec3(2)));
  const Bvh tree = tree_of(boxes, 8);
  const double nan = std::nan("");
  for (const Vec3& origin : {Vec3(0), Vec3(nan, 0, 0), Vec3(kInfinity, 1, 1), Vec3(1e300, 0, 0)})
    for (const Vec3& direction :
         {Vec3(0, 0, 1), Vec3(0, 0, 0), Vec3(nan, 1, 0), Vec3(1e-320, 0, 1), Vec3(kInfinity, 0, 0)})
      met_by_tree({origin, direction}, tree, 0, kInfinity);
}

TEST(Bvh, TheSameForAnyOrderOfThreads) {
  Random random(5);
  const auto boxes = boxes_around(random, Vec3(0), 60000);
  const Bvh a = tree_of(boxes, 4), b = tree_of(boxes, 4);
  EXPECT_EQ(a.order(), b.order());
  std::set<std::uint32_t> all(a.order().begin(), a.order().end());
  EXPECT_EQ(all.size(), boxes.size());
}

// All rays between two boxes, started at the entry points of their shaft, find what they find from the root.
TEST(Shaft, LosesNothing) {
  Random random(6);
  int shafts = 0, complete = 0;
  std::size_t found = 0;
  for (const double offset : {0.0, 1e4}) {
    const Vec3 center = random.point(offset);
    const auto boxes = boxes_around(random, center, 3000);
    for (const unsigned leaf_size : {1u, 4u}) {
      const Bvh tree = tree_of(boxes, leaf_size);
      for (int i = 0; i < 1500; ++i) {
        const auto box = [&](double place) {
          const double size = random.below(3) == 0 ? 0 : std::pow(10.0, random(-3, 1));
          Vec3 half = random.point(size);
          for (int k = 0; k < 3; ++k) half[k] = random.below(4) == 0 ? 0 : std::fabs(half[k]);
          const Vec3 p = center + random.point(place);
          return Box3(p - half, p + half);
        };
        Box3 from = box(12), to = box(random.below(3) == 0 ? 12 : random.below(2) ? 100 : 1e6);
        if (random.below(4) == 0)
          to = Box3(from.min + Vec3(0, 30, 0), from.max + Vec3(0, 30, 0));  // parallel rays along an axis
        const auto shaft = Shaft::between(from, to);
        if (!shaft) continue;
        ++shafts;
        EntryPoints entry;
        tree.enter(*shaft, entry);
        complete += entry.complete;
        for (int k = 0; k < 12; ++k) {
          const Vec3 a = k < 2 ? from.min : k < 4 ? from.max : random.in(from), b = k % 2 ? to.min : random.in(to);
          const double distance = length(b - a);
          const Ray ray{a, (b - a) / distance};
          const auto expected = met_by_test(ray, boxes, 0, distance),
                     actual = met_by_tree(ray, tree, 0, distance, &entry);
          ASSERT_TRUE(std::includes(actual.begin(), actual.end(), expected.begin(), expected.end())) << i << ' ' << k;
          found += expected.size();
        }
      }
    }
  }
  EXPECT_GT(shafts, 3000);
  EXPECT_GT(complete, 300);
  EXPECT_GT(found, 10000u);
}

TEST(Shaft, NoneBetweenBoxesThatAreClose) {
  EXPECT_FALSE(Shaft::between(Box3(Vec3(0), Vec3(2)), Box3(Vec3(1), Vec3(3))));
  EXPECT_FALSE(Shaft::between(Box3(Vec3(0), Vec3(2)), Box3(Vec3(2.1), Vec3(3))));
  EXPECT_FALSE(Shaft::between(Box3(Vec3(0)), Box3(Vec3(0))));
  EXPECT_FALSE(Shaft::between(Box3(Vec3(0)), Box3(Vec3(kInfinity))));
  EXPECT_FALSE(Shaft::between(Box3(Vec3(std::nan(""))), Box3(Vec3(1))));
  EXPECT_TRUE(Shaft::between(Box3(Vec3(0)), Box3(Vec3(0, 0, 1e-9))));
}

TEST(Shaft, MeetsFewBoxesBesideIt) {
  Random random(7);
  const auto boxes = boxes_around(random, Vec3(0), 10000);
  const Bvh tree(boxes);
  std::size_t entries = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random.point(10) + Vec3(0, 0, -40);
    EntryPoints entry;
    tree.enter(*Shaft::between(Box3(p), Box3({-p.x, -p.y, 40}, {-p.x + 0.1, -p.y + 0.1, 40})), entry);
    entries += 4 * static_cast<std::size_t>(entry.count);
    EXPECT_LE(entry.count, EntryPoints::kNodes);
  }
  EXPECT_LT(entries, 200u * 16);
  EntryPoints nothing;
  tree.enter(*Shaft::between(Box3(Vec3(50, 0, -40)), Box3(Vec3(50, 0, 40))), nothing);
  EXPECT_EQ(nothing.count, 0);
}

// Rays whose reciprocals are zero in single precision meet what is there, and no child that is missing.
TEST(Bvh, EndlessDirectionsEnd) {
  for (const std::size_t count : {1u, 2u, 3u, 5u, 6u, 9u}) {
    const auto box = [](std::size_t i) { return Box3(Vec3(double(i), -.5, -.5), Vec3(double(i) + .9, .5, .5)); };
    const Bvh tree(count, box, 1);
    for (const double size : {1e38, 1e100, -1e300}) {
      std::size_t visits = 0;
      tree.traverse({Vec3(.1, .1, .2), Vec3(size, size, size / 2)}, 0, kInfinity, [&](std::uint32_t, double limit) {
        ++visits;
        return limit;
      });
      EXPECT_LE(visits, count) << size;
    }
  }
}

}  // namespace
}  // namespace verisim::accel
