// POV-Ray's noise and turbulence (spec 05 section 5).
//
// Everything here runs in vector instructions, as wide as the machine has them, and gives the same bits on every
// machine: the order of all additions is written down in noise_kernels.cpp and no products are fused.
#pragma once

#include "tracer/math/vec.h"

namespace verisim::textures {

constexpr int kMaxOctaves = 10;

// The octaves of a turbulence: frequency lambda^i and weight omega^i. Made once for a texture.
struct Octaves {
  Octaves(int octaves, double lambda, double omega);

  int count;        // 1 to kMaxOctaves
  double farthest;  // points beyond, on any axis, have octaves that do not fit into 32-bit lattice coordinates
  alignas(64) double scale[16], weight[16];  // zero beyond count
};

// Scalar noise in [0, 1]; generator 1 (original), 2 (range corrected) or 3 (gradient noise).
double noise(const Vec3& p, int generator);
// The values at any number of points, as `noise` gives them one by one. Coordinate i of point k is points[i * stride +
// k].
void noise(int generator, const double* points, std::size_t stride, std::size_t count, double* values);
// Vector noise D; the same for every generator, not clamped.
Vec3 vector_noise(const Vec3& p);

// Sum of noises over the octaves. Generators 2 and 3 may leave [0, 1].
double turbulence(const Vec3& p, const Octaves& octaves, int generator);
Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves);
inline double turbulence(const Vec3& p, int octaves, double lambda, double omega, int generator) {
  return turbulence(p, Octaves(octaves, lambda, omega), generator);
}
inline Vec3 vector_turbulence(const Vec3& p, int octaves, double lambda, double omega) {
  return vector_turbulence(p, Octaves(octaves, lambda, omega));
}

// The fixed octave sums of the patterns granite and wrinkles.
double granite_sum(const Vec3& p, int generator);
double wrinkles_sum(const Vec3& p, int generator);
// Sum of abs(D(2^i p)) / 2^i, component by component: the bump of wrinkles.
Vec3 wrinkles_vector_sum(const Vec3& p);

// The plain, scalar formulas: what the fast versions above are tested against.
namespace reference {
double noise(const Vec3& p, int generator);
Vec3 vector_noise(const Vec3& p);
double turbulence(const Vec3& p, const Octaves& octaves, int generator);
Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves);
double granite_sum(const Vec3& p, int generator);
double wrinkles_sum(const Vec3& p, int generator);
Vec3 wrinkles_vector_sum(const Vec3& p);
}  // namespace reference

}  // namespace verisim::textures
