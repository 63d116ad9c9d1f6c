// Noise written down as spec 05 sections 5.2 and 5.3 state it, corner by corner.
#include <algorithm>

#include "tracer/noise/noise.h"
#include "tracer/noise/noise_tables.h"

namespace verisim::textures::reference {
namespace {

double smooth(double t) { return t * t * (3 - 2 * t); }

// Floor, except that values within epsilon below an integer round up.
// Far values saturate.
std::int64_t lattice(double x) {
  x = x < 0x1p62 ? x : 0x1p62;
  x = x > -0x1p62 ? x : -0x1p62;
  return static_cast<std::int64_t>(x >= 0 ? x : x - 1 + kEpsilon);
}

// The corners in the order in which they are added; x is the lowest bit.
constexpr int kRows[8] = {0, 1, 2, 3, 4, 5, 6, 7}, kNeighbours[8] = {0, 1, 3, 2, 6, 7, 5, 4};

double lattice_noise(const Vec3& p, int offset, const int (&order)[8]) {
  const NoiseTables& t = noise_tables();
  const std::int64_t i[3] = {lattice(p.x), lattice(p.y), lattice(p.z)};
  const double f[3] = {p.x - static_cast<double>(i[0]), p.y - static_cast<double>(i[1]),
                       p.z - static_cast<double>(i[2])};
  double sum = 0;
  for (const int c : order) {
    const int corner[3] = {c & 1, c >> 1 & 1, c >> 2};
    const int m =
        lattice_hash(t, i[0] + 10000 + corner[0], i[1] + 10000 + corner[1], i[2] + 10000 + corner[2]) % 256 + offset;
    double weight = 1, value = t.values[m] / 2;
    for (int k = 0; k < 3; ++k) {
      weight *= corner[k] ? smooth(f[k]) : 1 - smooth(f[k]);
      value += t.values[m + k + 1] * (f[k] - corner[k]);
    }
    sum += weight * value;
  }
  return sum;
}

double gradient_noise(const Vec3& p) {
  const NoiseTables& t = noise_tables();
  std::int64_t i[3];
  double r[3];
  for (int k = 0; k < 3; ++k) {
    const double shifted = p[k] + 10000000.023157213;
    i[k] = floor_to_int(shifted);
    r[k] = shifted - static_cast<double>(i[k]);
  }
  double values[8];
  for (int c = 0; c < 8; ++c) {
    const int corner[3] = {c & 1, c >> 1 & 1, c >> 2};
    const int x = t.permutation[(i[0] + corner[0]) & 2047];
    const int y = t.permutation[(x + i[1] + corner[1]) & 2047];
    const double* g = t.gradient_rows[(y + i[2] + corner[2]) & 2047];
    values[c] = 0;
    for (int k = 0; k < 3; ++k) values[c] += g[k + 1] * (r[k] - corner[k]);
  }
  for (int k = 0, count = 4; k < 3; ++k, count /= 2)
    for (int c = 0; c < count; ++c) values[c] = values[2 * c] + smooth(r[k]) * (values[2 * c + 1] - values[2 * c]);
  return values[0];
}

}  // namespace

double noise(const Vec3& p, int generator) {
  double n;
  switch (generator) {
    case 1:
      n = lattice_noise(p, 0, kRows) + 0.5;
      break;
    case 3:
      n = 0.5 * (1.59 * gradient_noise(p) + 0.985);
      break;
    default:
      n = (lattice_noise(p, 0, kRows) + 1.05242) * 0.48985582;
      break;
  }
  return std::clamp(n, 0.0, 1.0);
}

Vec3 vector_noise(const Vec3& p) {
  return {lattice_noise(p, 0, kNeighbours), lattice_noise(p, 4, kNeighbours), lattice_noise(p, 8, kNeighbours)};
}

double turbulence(const Vec3& p, const Octaves& octaves, int generator) {
  double sum = 0;
  for (int i = 0; i < octaves.count; ++i) {
    double n = noise(p * octaves.scale[i], generator);
    if (generator != 1) n = 2 * n - 0.5;
    if (generator != 1 && i == 0) n = std::clamp(n, 0.0, 1.0);
    sum += octaves.weight[i] * n;
  }
  return sum;
}

Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves) {
  Vec3 sum(0, 0, 0);
  for (int i = 0; i < octaves.count; ++i) sum += octaves.weight[i] * vector_noise(p * octaves.scale[i]);
  return sum;
}

double granite_sum(const Vec3& p, int generator) {
  double sum = 0, scale = 1;
  for (int i = 0; i < 6; ++i, scale *= 2) {
    const double n = noise(p * (4 * scale), generator);
    sum += (generator == 1 ? std::fabs(0.5 - n) : std::min(std::fabs(1 - 2 * n), 0.5)) / scale;
  }
  return sum;
}

double wrinkles_sum(const Vec3& p, int generator) {
  double sum = 0, scale = 1;
  for (int i = 0; i < 10; ++i, scale *= 2) {
    const double n = noise(p * scale, generator);
    sum += (generator == 1 ? n : std::clamp(2 * n - 0.5, 0.0, 1.0)) / scale;
  }
  return 0.5 * sum;
}

Vec3 wrinkles_vector_sum(const Vec3& p) {
  Vec3 sum(0, 0, 0);
  double scale = 1;
  for (int i = 0; i < 10; ++i, scale *= 2) {
    const Vec3 d = vector_noise(p * scale);
    sum += Vec3(std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)) / scale;
  }
  return sum;
}

}  // namespace verisim::textures::reference
