// Places of numbers in order, by comparing all with all: those of a stable sort, with every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "tracer/shapes/blob/blob_packet.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes {
namespace {

TEST(BlobRanks, AreThoseOfAStableSort) {
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const BlobKernels* kernels = blob_kernels(set);
    if (!kernels) continue;  // this machine cannot run it
    std::mt19937 random(3);
    for (int count = 1; count <= 64; ++count) {
      for (const unsigned different : {1u, 4u, 1000000u}) {
        alignas(64) double numbers[64], places[64];
        for (int i = 0; i < count; ++i) numbers[i] = static_cast<double>(random() % different) - 2;
        kernels->ranks(numbers, count, places);
        std::vector<int> order(static_cast<std::size_t>(count));
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {}, [&](int i) { return numbers[i]; });
        for (int place = 0; place < count; ++place)
          ASSERT_EQ(places[order[static_cast<std::size_t>(place)]], place) << set << ' ' << count << ' ' << different;
      }
    }
  }
}

}  // namespace
}  // namespace verisim::shapes
