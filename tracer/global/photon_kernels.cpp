#include "tracer/global/photon_kernels.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "tracer/textures/instruction_sets.h"

namespace verisim::global {
namespace {

template <class Integer>
constexpr std::array<Integer, PhotonPositions::kAtOnce> bits() {
  std::array<Integer, PhotonPositions::kAtOnce> result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = Integer{1} << i;
  return result;
}
constexpr auto kBit = bits<std::int32_t>();
constexpr auto kLongBit = bits<std::int64_t>();

#define VERISIM_KERNELS "tracer/global/photon_kernels.inc"
#include "tracer/textures/each_instruction_set.inc"

const PhotonKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const PhotonKernels* photon_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const PhotonKernels& photon_kernels() {
  static const PhotonKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::global
