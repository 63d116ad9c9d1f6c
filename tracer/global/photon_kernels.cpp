#include "tracer/global/photon_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "tracer/global/photon_order.h"
#include "tracer/global/photon_tree.h"
#include "tracer/textures/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::global {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr auto kAnyNumber = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kAtOnce = PhotonLeaf::kAtOnce;
constexpr std::size_t kCrowd = 3;  // times the wanted number of photons is when the nearest are picked out, and the search narrowed

#define VERISIM_KERNELS "tracer/global/photon_kernels.inc"
#include "tracer/textures/each_instruction_set.inc"

const PhotonKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

void PhotonDistances::grow(std::size_t size) {
  const std::size_t room = 2 * size + 4 * PhotonLeaf::kAtOnce;
  squared_.resize(room), index_.resize(room);
}

void PhotonDistances::erase(std::size_t i) {
  move(i + 1, size_, i);
  --size_;
}

void PhotonDistances::move(std::size_t from, std::size_t end, std::size_t to) {
  std::copy(squared_.data() + from, squared_.data() + end, squared_.data() + to);
  std::copy(index_.data() + from, index_.data() + end, index_.data() + to);
}

const PhotonKernels* photon_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const PhotonKernels& photon_kernels() {
  static const PhotonKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::global
