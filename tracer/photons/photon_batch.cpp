#include "tracer/photons/photon_batch.h"

#include <algorithm>

namespace verisim::global {

void add_light(const SomePhotons& photons, const PhotonSurface& surface, Rgb& sum) {
  PhotonBatch batch;
  for (std::size_t first = 0; first < photons.size(); first += PhotonBatch::kMax) {
    const std::size_t count = std::min(PhotonBatch::kMax, photons.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Photon& photon = photons[first + i];
      const Vec3 direction = photon.direction();
      const Rgb energy = photon.color();
      batch.x[i] = direction.x, batch.y[i] = direction.y, batch.z[i] = direction.z;
      batch.r[i] = energy.r, batch.g[i] = energy.g, batch.b[i] = energy.b;
    }
    photon_batch_kernels().shade(surface, count, batch);
    for (std::size_t i = 0; i < count; ++i) sum += Rgb(batch.r[i], batch.g[i], batch.b[i]);
  }
}

}  // namespace verisim::global
