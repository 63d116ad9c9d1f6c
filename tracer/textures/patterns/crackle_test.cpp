// The remembered cells of crackle against a plain search of all 81 cells, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tracer/simd/instruction_sets.h"
#include "tracer/textures/patterns/crackle_kernels.h"
#include "tracer/textures/patterns/crackle_offsets.h"

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
    for (const CrackleMetric metric : {CrackleMetric::squares, CrackleMetric::sums}) {
      std::vector<double> all;
      for (const CellOffset& o : kCrackleOffsets) {
        const Vec3 d = Vec3(o.x, o.y, o.z) + cell_point(t, a + o.x, b + o.y, c + o.z) - place;
        all.push_back(metric == CrackleMetric::squares ? d.x * d.x + d.y * d.y + d.z * d.z
                                                       : std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
      }
      std::partial_sort(all.begin(), all.begin() + 3, all.end());
      const CrackleCell& cell = crackle_cell(metric, a, b, c);
      for (int set = 0; set <= simd::best_instruction_set(); ++set) {
        const CrackleKernels& kernels = *crackle_kernels(set);
        const NearestThree nearest =
            metric == CrackleMetric::squares ? kernels.squares(cell, place) : kernels.sums(cell, place);
        for (int k = 0; k < 3; ++k) ASSERT_EQ(nearest.s[k], all[k]) << "instruction set " << set;
      }
    }
  }
}

}  // namespace
}  // namespace verisim::textures
