#include "tracer/photons/photon_row.h"

#include <algorithm>

namespace verisim::global {

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
