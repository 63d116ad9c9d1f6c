#include "tracer/photons/photon_row.h"

#include <algorithm>
#include <cmath>

#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

#define VERISIM_KERNELS "tracer/photons/photon_row.inc"
#include "tracer/simd/each_instruction_set.inc"

const PhotonRowKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const PhotonRowKernels* photon_row_kernels(int set) {
  return set <= simd::best_instruction_set() ? kAll[set] : nullptr;
}

const PhotonRowKernels& photon_row_kernels() {
  static const PhotonRowKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

void add_light(const SomePhotons& photons, const PhotonSurface& surface, Rgb& sum) {
  PhotonRow row;
  for (std::size_t first = 0; first < photons.size(); first += PhotonRow::kMost) {
    const std::size_t count = std::min(PhotonRow::kMost, photons.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Photon& photon = photons[first + i];
      const Vec3 direction = photon.direction();
      const Rgb energy = photon.color();
      row.x[i] = direction.x, row.y[i] = direction.y, row.z[i] = direction.z;
      row.r[i] = energy.r, row.g[i] = energy.g, row.b[i] = energy.b;
    }
    photon_row_kernels().shade(surface, count, row);
    for (std::size_t i = 0; i < count; ++i) sum += Rgb(row.r[i], row.g[i], row.b[i]);
  }
}

}  // namespace verisim::global
