// What photons around a point add to a plain diffuse layer (spec 07 section 3.10), a batch of them at a time. Compiled
// for several instruction sets; every lane does the operations of the scalar code in the same order.
#pragma once

#include <span>

#include "tracer/photons/photon.h"

namespace verisim::global {

// Photons side by side. Behind the last one stands any number.
struct alignas(64) PhotonBatch {
  static constexpr std::size_t kMax = 64;
  double x[kMax], y[kMax], z[kMax];  // unit directions towards the light
  float r[kMax], g[kMax], b[kMax];   // energy; then what is added
};

// A layer whose brilliance is 1.
struct PhotonSurface {
  Vec3 normal, geometric_normal;  // normal: to shade with
  Rgb pigment;
  double front, behind;  // opacity * diffuse coefficient on the side that is turned to a photon's light, and on the
                         // other; 0: nothing is added
};

struct PhotonBatchKernels {
  void (*shade)(const PhotonSurface& surface, std::size_t count, PhotonBatch& batch);
};

const PhotonBatchKernels& photon_batch_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const PhotonBatchKernels* photon_batch_kernels(int instruction_set);

// Adds the light of the photons to `sum`, in their order; it is to be divided by the area of the disc they are from.
void add_light(const SomePhotons& photons, const PhotonSurface& surface, Rgb& sum);

}  // namespace verisim::global
