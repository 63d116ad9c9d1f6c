// The remembered cells of crackle against a plain search of all 81 cells, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tracer/simd/instruction_sets.h"
#include "tracer/textures/patterns/crackle_kernels.h"
#include "tracer/textures/patterns/crackle_offsets.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

TEST(Crackle, RemembersEveryPointThatCanBeAmongTheNearestThree) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<int> index(-5000, 5000);
  const NoiseTables& t = noise_tables();
  for (int i = 0; i < 3000; ++i) {
    const int a = index(random), b = index(random), c = index(random);
    Vec3 place(unit(random), unit(random), unit(random));
    if (i % 5 == 0) place.x = i % 10 == 0 ? 1 : 1e-10;  // on the faces
    if (i % 7 == 0) place.z = i % 14 == 0 ? 1 : 1e-10;
    const Vec3 corner(a, b, c), p = corner + place;
    for (const CrackleMetric metric : {CrackleMetric::squares, CrackleMetric::sums}) {
      std::vector<double> all;
      for (const CellOffset& o : kCrackleOffsets) {
        const Vec3 d = corner + (Vec3(o.x, o.y, o.z) + cell_point(t, a + o.x, b + o.y, c + o.z)) - p;
        all.push_back(metric == CrackleMetric::squares ? d.x * d.x + d.y * d.y + d.z * d.z
                                                       : std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
      }
      std::partial_sort(all.begin(), all.begin() + 3, all.end());
      const CrackleCell& cell = crackle_cell(metric, a, b, c);
      for (int set = 0; set <= simd::best_instruction_set(); ++set) {
        const CrackleKernels& kernels = *crackle_kernels(set);
        const NearestThree nearest =
            metric == CrackleMetric::squares ? kernels.squares(cell, p) : kernels.sums(cell, p);
        for (int k = 0; k < 3; ++k) ASSERT_EQ(nearest.s[k], all[k]) << "instruction set " << set;
      }
    }
  }
}

// Points of other metrics that are passed over because of their squares are never among the nearest three.
TEST(Crackle, OfAnyMetricIsWhatAPlainSearchFinds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-40, 40);
  const NoiseTables& t = noise_tables();
  for (const double metric : {0.3, 0.5, 0.9, 1.5, 1.99, 2.01, 2.5, 3.0, 7.0, 30.0, 64.0, 100.0, -1.0}) {
    CrackleData data{};
    data.p.metric = metric;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p(place(random), place(random), place(random));
      const double cell[3] = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
      std::vector<double> all;
      for (const CellOffset& o : kCrackleOffsets) {
        const Vec3 random_point = Vec3(o.x, o.y, o.z) + cell_point(t, floor_to_int(p.x) + o.x, floor_to_int(p.y) + o.y,
                                                                   floor_to_int(p.z) + o.z);
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += std::pow(std::fabs(cell[k] + random_point[k] - p[k]), metric);
        all.push_back(sum);
      }
      std::partial_sort(all.begin(), all.begin() + 3, all.end());
      for (int k = 0; k < 3; ++k) {
        for (int other = 0; other < 3; ++other) data.p.form[other] = other == k ? 0.25 : 0;
        const double expected = std::clamp(0.25 * std::pow(all[k], 1 / metric), 0.0, 1.0);
        ASSERT_EQ(crackle(data, 2, p), expected) << "metric " << metric << ", the nearest but " << k;
      }
    }
  }
}

// `metric 0` has infinite roots, of which a form of 0 makes no number.
TEST(Crackle, InfiniteRoots) {
  CrackleData data{};
  data.p.metric = 0;
  const auto value = [&](double f1, double f2, double f3) {
    data.p.form[0] = f1, data.p.form[1] = f2, data.p.form[2] = f3;
    return crackle(data, 2, {0.3, 0.2, 0.1});
  };
  EXPECT_EQ(value(0.1, 0.2, 0.3), 1);
  EXPECT_TRUE(std::isnan(value(0.1, 0, 0)));
  EXPECT_TRUE(std::isnan(value(-1, 1, 0)));
}

}  // namespace
}  // namespace verisim::textures
