#include "tracer/photons/photon_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "tracer/photons/photon_order.h"
#include "tracer/photons/photon_tree.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

constexpr std::size_t kAtOnce = kPhotonsAtOnce;

class PhotonKernelsTest : public testing::Test {
 protected:
  template <class Check>
  void for_each_instruction_set(Check&& check) {
    for (int set = 0; set < simd::kInstructionSets; ++set) {
      if (const PhotonKernels* kernels = photon_kernels(set)) check(*kernels);
    }
  }
  double random() { return uniform_(generator_); }
  Vec3 random_vector() { return {random(), random(), random()}; }
  PhotonList random_photons(std::size_t n) {
    PhotonList photons;
    for (std::size_t i = 0; i < n; ++i) {
      PhotonPosition at;
      for (float& x : at) x = static_cast<float>(random());
      photons.add(at, {});
    }
    photons.fit();
    sort_photons(photons);
    return photons;
  }

  std::mt19937 generator_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

double flattened(const PhotonPosition& photon, const PhotonCenter& center) {
  const Vec3 d = Vec3(photon[0], photon[1], photon[2]) - center.point;
  return dot(d, d) * (1.0 + 16.0 * std::fabs(dot(center.normal, d)));
}

TEST_F(PhotonKernelsTest, BoxesAreAsNearAsThePlainFormulasSay) {
  PhotonBoxes boxes;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < kAtOnce; ++i)
      boxes.low[a][i] = static_cast<float>(random()), boxes.high[a][i] = boxes.low[a][i] + 0.3f;
  }
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    for (std::size_t run = 0; run < 500; ++run) {
      const std::array<float, 3> at{static_cast<float>(random()), static_cast<float>(random()),
                                    static_cast<float>(random())};
      const auto limit = static_cast<float>(1 + random());
      const unsigned met = kernels.boxes(boxes, at, limit);
      for (std::size_t i = 0; i < kAtOnce; ++i) {
        float gaps = 0;
        for (std::size_t a = 0; a < 3; ++a) {
          const float gap = std::max({0.0f, boxes.low[a][i] - at[a], at[a] - boxes.high[a][i]});
          gaps += gap * gap;
        }
        EXPECT_EQ(met >> i & 1, gaps <= limit);
      }
    }
  });
}

TEST_F(PhotonKernelsTest, CollectFindsAllWithinALimitInTheOrderOfTheMap) {
  // As many as make trees of one to four levels of nodes, with leaves that are full and others.
  for (const std::size_t count : {1u, 15u, 16u, 17u, 255u, 256u, 257u, 4096u, 5000u, 70000u}) {
    const PhotonList photons = random_photons(count);
    PhotonTree tree;
    tree.build(photons.positions);
    for_each_instruction_set([&](const PhotonKernels& kernels) {
      PhotonDistances found;
      for (int run = 0; run < 30; ++run) {
        const PhotonCenter center{random_vector(), run % 2 == 0 ? Vec3(0.0) : normalize(random_vector())};
        double limit = 0.5 * (1.01 + random());
        const double asked = limit;
        ASSERT_EQ(kernels.collect(tree, {{photons.positions.data(), center}, kAnyNumber, kAnyNumber, nullptr, 0.0},
                                  limit, found),
                  Collected::all);
        EXPECT_EQ(limit, asked);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < count; ++i) {
          if (flattened(photons.positions[i], center) < limit) expected.push_back(i);
        }
        ASSERT_TRUE(std::ranges::equal(found.index(), expected)) << count << ' ' << run;
        for (std::size_t k = 0; k < found.size(); ++k)
          EXPECT_EQ(found.squared()[k], static_cast<float>(flattened(photons.positions[found.index()[k]], center)));
      }
    });
  }
}

TEST_F(PhotonKernelsTest, CollectNarrowsACrowdToItsNearest) {
  const PhotonList photons = random_photons(3000);
  PhotonTree tree;
  tree.build(photons.positions);
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances found, all;
    for (int run = 0; run < 30; ++run) {
      const PhotonCenter center{random_vector(), Vec3(0.0)};
      double limit = 1.0, any = 1.0;
      ASSERT_EQ(kernels.collect(tree, {{photons.positions.data(), center}, 40, kAnyNumber, nullptr, 0.0}, limit, found),
                Collected::nearest);
      EXPECT_LT(limit, 1.0);
      kernels.collect(tree, {{photons.positions.data(), center}, kAnyNumber, kAnyNumber, nullptr, 0.0}, any, all);
      kernels.keep_within(all, {photons.positions.data(), center}, limit, all);
      EXPECT_TRUE(std::ranges::includes(found.index(), all.index()));
      EXPECT_GE(found.size(), 40u);
      double too_far = 1.0;
      EXPECT_EQ(kernels.collect(tree, {{photons.positions.data(), center}, 40, 30, nullptr, 0.0}, too_far, found),
                Collected::too_many);
    }
  });
}

// Some lists with many photons that are equally far, some with many that differ less than floats can tell.
std::vector<PhotonPosition> photons_of(std::size_t size, int kind, const std::function<double()>& random) {
  std::vector<PhotonPosition> photons(size);
  for (PhotonPosition& p : photons) {
    const double x = kind == 0   ? std::round(4 * random())
                     : kind == 1 ? 1.0
                                 : random(),
                 y = kind == 1 ? 2e-4 * random() : 0.0;
    p = {static_cast<float>(x), static_cast<float>(y), 0.0f};
  }
  return photons;
}

TEST_F(PhotonKernelsTest, TheNearestAreKeptInTheirOrder) {
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances list, kept;
    for (std::size_t run = 0; run < 400; ++run) {
      const std::size_t size = 2 + run;
      const std::vector<PhotonPosition> photons = photons_of(size, static_cast<int>(run % 4), [&] { return random(); });
      const PhotonMeasure measure{photons.data(), {Vec3(0.0), Vec3(0.0)}};
      list.clear();
      std::vector<std::pair<double, std::uint32_t>> expected;
      for (std::uint32_t i = 0; i < size; ++i)
        list.add(i, measure.squared(i)), expected.emplace_back(measure.squared(i), i);
      std::ranges::sort(expected);
      const std::size_t maximum = 1 + run * 7 % (size - 1);
      expected.resize(maximum);
      double limit = 16.0;
      kernels.keep_nearest(list, measure, maximum, limit, kept);
      EXPECT_EQ(limit, expected.back().first);
      std::ranges::sort(expected, {}, [](const auto& e) { return e.second; });
      ASSERT_EQ(kept.size(), maximum);
      for (std::size_t k = 0; k < maximum; ++k) {
        EXPECT_EQ(kept.index()[k], expected[k].second) << run;
        EXPECT_EQ(kept.squared()[k], static_cast<float>(expected[k].first));
      }
      kernels.keep_nearest(list, measure, maximum, limit, list);
      EXPECT_TRUE(std::ranges::equal(list.index(), kept.index()));
    }
  });
}

TEST_F(PhotonKernelsTest, ThoseWithinALimitAreKept) {
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances list, kept;
    for (std::size_t run = 0; run < 100; ++run) {
      const std::vector<PhotonPosition> photons =
          photons_of(2 + run, static_cast<int>(run % 4), [&] { return random(); });
      const PhotonMeasure measure{photons.data(), {Vec3(0.0), Vec3(0.0)}};
      list.clear();
      for (std::uint32_t i = 0; i < photons.size(); ++i) list.add(i, measure.squared(i));
      const double limit = measure.squared(static_cast<std::uint32_t>(run / 2));
      kernels.keep_within(list, measure, limit, kept);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < photons.size(); ++i) {
        if (measure.squared(i) <= limit) expected.push_back(i);
      }
      EXPECT_TRUE(std::ranges::equal(kept.index(), expected)) << run;
    }
  });
}

// Too far for floats.
TEST_F(PhotonKernelsTest, HugeDistancesAreCompared) {
  PhotonList photons = random_photons(300);
  for (PhotonPosition& p : photons.positions) {
    for (float& x : p) x *= 1e18f;
  }
  PhotonTree tree;
  tree.build(photons.positions);
  const PhotonMeasure measure{photons.positions.data(), {Vec3(1e17, 0, 0), Vec3(0, 1, 0)}};
  std::vector<std::pair<double, std::uint32_t>> expected;
  for (std::uint32_t i = 0; i < photons.size(); ++i) expected.emplace_back(measure.squared(i), i);
  std::ranges::sort(expected);
  EXPECT_GT(expected.front().first, 3.4e38);
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances found, kept;
    double limit = 1e60;
    ASSERT_EQ(kernels.collect(tree, {measure, kAnyNumber, kAnyNumber, nullptr, 0.0}, limit, found), Collected::all);
    ASSERT_EQ(found.size(), photons.size());
    kernels.keep_nearest(found, measure, 20, limit, kept);
    EXPECT_EQ(limit, expected[19].first);
    EXPECT_EQ(kept.size(), 20u);
  });
}

TEST_F(PhotonKernelsTest, ReachingFindsThoseThatComeNearToARadius) {
  constexpr std::size_t kCount = 60;
  PhotonOverhangs overhangs{std::vector<std::uint8_t>(kCount + 3, 0), (127u << 3) - 20};  // 2 to the -2.5 and more
  for (std::size_t i = 0; i < kCount; ++i)
    overhangs.levels[i] = i % 3 == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(20 + 8 * random());
  for_each_instruction_set([&](const PhotonKernels& kernels) {
    PhotonDistances list;
    for (std::uint32_t i = 0; i < kCount; i += 1 + i % 2) list.add(i, 1 + random());
    std::array<std::uint32_t, 100> places;
    const std::size_t count = kernels.reaching(list, overhangs, 1.3, places.data());
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < list.size(); ++k) {
      const std::uint32_t level = overhangs.levels[list.index()[k]];
      const double rest = 1.3 - std::bit_cast<float>((overhangs.base + level) << PhotonOverhangs::kShift);
      if (level > 0 && (rest <= 0.0 || list.squared()[k] >= rest * rest * (1 - 1e-5))) expected.push_back(k);
    }
    EXPECT_FALSE(expected.empty());
    EXPECT_LT(expected.size(), list.size());
    EXPECT_TRUE(std::ranges::equal(std::span(places.data(), count), expected));
  });
}

}  // namespace
}  // namespace verisim::global
