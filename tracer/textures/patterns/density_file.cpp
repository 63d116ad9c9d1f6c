#include "tracer/textures/patterns/density_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

class Grid {
 public:
  explicit Grid(const scene::DensityFileParams& d)
      : d_(d),
        scale_(d.bytes == 1   ? 255.0
               : d.bytes == 2 ? 65535.0
                              : 4294967295.0) {}
  double operator()(std::uint64_t x, std::uint64_t y, std::uint64_t z) const {
    const auto nx = static_cast<std::uint64_t>(d_.size[0]), ny = static_cast<std::uint64_t>(d_.size[1]);
    return (*d_.samples)[(z * ny + y) * nx + x] / scale_;
  }

 private:
  const scene::DensityFileParams& d_;
  double scale_;
};

// The cubic of spec 05 through four neighbours, in single precision as POV-Ray computes it.
float cubic(float a, float b, float c, float d, float t) {
  const float slope_b = (c - a) / 2, slope_c = (d - b) / 2, step = b - c;
  const float e = 2 * step + slope_b + slope_c;
  const float f = -3 * step - 2 * slope_b - slope_c;
  return b + t * (slope_b + t * (f + t * e));
}

}  // namespace

double density_file(const scene::DensityFileParams& d, const Vec3& p) {
  if (!d.samples || d.samples->empty()) return 0;
  std::uint64_t i[3];
  double f[3];
  for (int k = 0; k < 3; ++k) {
    if (!(p[k] >= 0 && p[k] < 1)) return 0;
    const double scaled = p[k] * d.size[k];
    i[k] = std::min(static_cast<std::uint64_t>(scaled), static_cast<std::uint64_t>(d.size[k] - 1));
    f[k] = scaled - static_cast<double>(i[k]);
  }
  const Grid grid(d);
  const int mode = d.interpolate % 10;
  if (mode == 0) return grid(i[0], i[1], i[2]);
  // Unsigned 64-bit arithmetic modulo the size: index -1 is (2^64 - 1) mod n, not n - 1, as in POV-Ray.
  std::uint64_t near[3][4];
  for (int k = 0; k < 3; ++k)
    for (std::uint64_t j = 0; j < 4; ++j) near[k][j] = (i[k] + j - 1) % static_cast<std::uint64_t>(d.size[k]);
  if (mode == 1) {
    double sum = 0;
    for (int c = 0; c < 8; ++c) {
      const int x = c & 1, y = c >> 1 & 1, z = c >> 2;
      sum += (x ? f[0] : 1 - f[0]) * (y ? f[1] : 1 - f[1]) * (z ? f[2] : 1 - f[2]) *
             grid(near[0][1 + x], near[1][1 + y], near[2][1 + z]);
    }
    return sum;
  }
  float column[4];
  for (int x = 0; x < 4; ++x) {
    float row[4];
    for (int y = 0; y < 4; ++y) {
      float v[4];
      for (int z = 0; z < 4; ++z) v[z] = static_cast<float>(grid(near[0][x], near[1][y], near[2][z]));
      row[y] = cubic(v[0], v[1], v[2], v[3], static_cast<float>(f[2]));
    }
    column[x] = cubic(row[0], row[1], row[2], row[3], static_cast<float>(f[1]));
  }
  return std::max(cubic(column[0], column[1], column[2], column[3], static_cast<float>(f[0])), 0.0f);
}

double formulas::density_file(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return textures::density_file(c.as<scene::DensityFileParams>(), p);
}

}  // namespace verisim::textures
