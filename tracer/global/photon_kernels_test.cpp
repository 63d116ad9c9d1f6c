#include "tracer/global/photon_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tracer/global/photon_order.h"
#include "tracer/global/photon_tree.h"
#include "tracer/textures/instruction_sets.h"

namespace verisim::global {
namespace {

constexpr std::size_t kAtOnce = PhotonLeaf::kAtOnce;
constexpr auto kAny = std::numeric_limits<std::size_t>::max();

class PhotonKernelsTest : public testing::Test {
 protected:
  template <class Check>
  void for_each_instruction_set(Check&& check) {
    for (int set = 0; set < textures::kInstructionSets; ++set) {
      if (const PhotonKernels* kernels = photon_kernels(set)) check(*kernels);
    }
  }
  double random() { return uniform_(generator_); }
  Vec3 random_vector() { return {random(), random(), random()}; }
  std::vector<Photon> random_photons(std::size_t n) {
    std::vector<Photon> photons(n);
    for (Photon& p : photons) {
      for (float& x : p.position) x = static_cast<float>(random());
    }
    sort_photons(photons);
    return photons;
  }

  std::mt19937 generator_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

double flattened(const Photon& photon, const PhotonCenter& center) {
  const Vec3 d = Vec3(photon.position[0], photon.position[1], photon.position[2]) - center.point;
  return dot(d, d) * (1.0 + 16.0 * std::fabs(dot(center.normal, d)));
}

TEST_F(PhotonKernelsTest, SixteenDistancesAreThoseOfThePlainFormulas) {
  const std::vector<Photon> photons = random_photons(13);
  PhotonTree tree;
  tree.build(photons);
  ASSERT_EQ(tree.leaves().size(), 1u);
  const PhotonLeaf& leaf = tree.leaves().front();
  PhotonBoxes boxes;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < kAtOnce; ++i) boxes.low[a][i] = static_cast<float>(random()), boxes.high[a][i] = boxes.low[a][i] + 0.3f;
  }
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    for (std::size_t run = 0; run < 500; ++run) {
      const PhotonCenter center{random_vector(), run % 3 == 0 ? Vec3(0.0) : normalize(random_vector())};
      const double limit = 1 + random();
      std::array<double, kAtOnce> squared;
      const unsigned near = kernels.near(leaf, center, limit, squared.data());
      const std::array<float, 3> at{static_cast<float>(center.point.x), static_cast<float>(center.point.y), static_cast<float>(center.point.z)};
      const unsigned met = kernels.boxes(boxes, at, static_cast<float>(limit));
      for (std::size_t i = 0; i < kAtOnce; ++i) {
        if (i < photons.size()) {
          EXPECT_EQ(squared[i], flattened(photons[i], center));
        }
        EXPECT_EQ(near >> i & 1, i < photons.size() && squared[i] < limit);
        float gaps = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          const float gap = std::max({0.0f, boxes.low[a][i] - at[a], at[a] - boxes.high[a][i]});
          gaps += gap * gap;
        }
        EXPECT_EQ(met >> i & 1, gaps <= static_cast<float>(limit));
      }
    }
  });
}

TEST_F(PhotonKernelsTest, CollectFindsAllWithinALimitInTheOrderOfTheMap) {
  // As many as make trees of one to four levels, with leaves that are full and others.
  for (const std::size_t count : {1u, 15u, 16u, 17u, 255u, 256u, 257u, 4096u, 5000u}) {
    const std::vector<Photon> photons = random_photons(count);
    PhotonTree tree;
    tree.build(photons);
    for_each_instruction_set([&](const PhotonKernels& kernels) {
      PhotonDistances found;
      for (int run = 0; run < 30; ++run) {
        const PhotonCenter center{random_vector(), run % 2 == 0 ? Vec3(0.0) : normalize(random_vector())};
        double limit = 0.5 * (1.01 + random());
        const double asked = limit;
        ASSERT_EQ(kernels.collect(tree, {center, kAny, kAny, nullptr, 0.0}, limit, found), Collected::all);
        EXPECT_EQ(limit, asked);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < count; ++i) {
          if (flattened(photons[i], center) < limit) expected.push_back(i);
        }
        ASSERT_TRUE(std::ranges::equal(found.index(), expected)) << count << ' ' << run;
        for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found.squared()[k], flattened(photons[found.index()[k]], center));
      }
    });
  }
}

TEST_F(PhotonKernelsTest, CollectNarrowsACrowdToItsNearest) {
  const std::vector<Photon> photons = random_photons(3000);
  PhotonTree tree;
  tree.build(photons);
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances found, all;
    for (int run = 0; run < 30; ++run) {
      const PhotonCenter center{random_vector(), Vec3(0.0)};
      double limit = 1.0, any = 1.0;
      ASSERT_EQ(kernels.collect(tree, {center, 40, kAny, nullptr, 0.0}, limit, found), Collected::nearest);
      EXPECT_LT(limit, 1.0);
      kernels.collect(tree, {center, kAny, kAny, nullptr, 0.0}, any, all);
      kernels.keep_within(all, limit, all);
      EXPECT_TRUE(std::ranges::includes(found.index(), all.index()));
      EXPECT_GE(found.size(), 40u);
      double too_far = 1.0;
      EXPECT_EQ(kernels.collect(tree, {center, 40, 30, nullptr, 0.0}, too_far, found), Collected::too_many);
    }
  });
}

TEST_F(PhotonKernelsTest, TheNearestAreKeptInTheirOrder) {
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances list, kept;
    for (std::size_t run = 0; run < 400; ++run) {
      list.clear();
      const std::size_t size = 2 + run;
      // Some with many that are equally far.
      for (std::uint32_t i = 0; i < size; ++i) list.add(i, run % 4 == 0 ? std::round(4 * (1 + random())) : 1 + random());
      std::vector<std::pair<double, std::uint32_t>> expected;
      for (std::uint32_t i = 0; i < size; ++i) expected.emplace_back(list.squared()[i], i);
      std::ranges::sort(expected);
      const std::size_t maximum = 1 + run * 7 % (size - 1);
      expected.resize(maximum);
      double limit = 8.0;
      kernels.keep_nearest(list, maximum, limit, kept);
      EXPECT_EQ(limit, expected.back().first);
      std::ranges::sort(expected, {}, [](const auto& e) { return e.second; });
      ASSERT_EQ(kept.size(), maximum);
      for (std::size_t k = 0; k < maximum; ++k) EXPECT_EQ(std::pair(kept.squared()[k], kept.index()[k]), expected[k]);
      kernels.keep_nearest(list, maximum, limit, list);
      EXPECT_TRUE(std::ranges::equal(list.index(), kept.index()));
    }
  });
}

TEST_F(PhotonKernelsTest, ReachingFindsThoseThatComeNearToARadius) {
  std::vector<float> overhang(60);
  for (std::size_t i = 0; i < overhang.size(); ++i) overhang[i] = i % 3 == 0 ? -std::numeric_limits<float>::infinity() : static_cast<float>(1 + random());
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances list;
    for (std::uint32_t i = 0; i < overhang.size(); i += 1 + i % 2) list.add(i, 1 + random());
    std::array<std::uint32_t, 100> places;
    const std::size_t count = kernels.reaching(list, overhang.data(), 1.3, places.data());
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < list.size(); ++k) {
      const double rest = 1.3 - overhang[list.index()[k]];
      if (rest <= 0.0 || list.squared()[k] >= rest * rest) expected.push_back(k);
    }
    EXPECT_FALSE(expected.empty());
    EXPECT_LT(expected.size(), list.size());
    EXPECT_TRUE(std::ranges::equal(std::span(places.data(), count), expected));
  });
}

}  // namespace
}  // namespace verisim::global
