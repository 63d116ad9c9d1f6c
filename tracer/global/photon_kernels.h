// How far sixteen photons of a map, or boxes around them, are from a point, at once. Compiled for several instruction sets; every lane does the operations of the scalar code in
// the same order.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tracer/math/vec.h"

namespace verisim::global {

// Coordinates side by side; behind the last are as many more as a kernel may read.
struct PhotonPositions {
  static constexpr std::size_t kAtOnce = 16;
  std::vector<float> x, y, z;
  void resize(std::size_t n) {
    for (std::vector<float>* v : {&x, &y, &z}) v->assign(n + kAtOnce - 1, 0.0f);
  }
};

// Sixteen boxes around photons; those that are left over are empty.
struct alignas(64) PhotonBoxes {
  std::array<float, PhotonPositions::kAtOnce> low[3], high[3];
};

struct PhotonKernels {
  // Bit i: box i is nearer to the point than the square root of `squared`, or as near.
  unsigned (*boxes)(const PhotonBoxes& boxes, const std::array<float, 3>& point, float squared);
  // Squared distances of sixteen photons from number `first` on. Those off the plane through `point` are flattened away: they are larger by a factor
  // 1 + 16 |normal . delta|; a normal of zero leaves them as they are. Bit i: squared[i] < limit.
  unsigned (*near)(const PhotonPositions& photons, std::size_t first, const Vec3& point, const Vec3& normal, double limit, double* squared);
  // Bit i: number i of sixteen is at least `from` and less than `below`.
  unsigned (*within)(const double* numbers, double from, double below);
  // How many of n numbers are smaller.
  std::size_t (*below)(const double* numbers, std::size_t n, double limit);
};

const PhotonKernels& photon_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const PhotonKernels* photon_kernels(int instruction_set);

}  // namespace verisim::global
