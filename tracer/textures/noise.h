// POV-Ray's noise and turbulence (spec 05 section 5).
#pragma once

#include "tracer/math/vec.h"

namespace verisim::textures {

// Scalar noise in [0, 1]; generator 1 (original), 2 (range corrected) or 3 (gradient noise).
double noise(const Vec3& p, int generator);
// Vector noise D; the same for every generator, not clamped.
Vec3 vector_noise(const Vec3& p);

// Sum of `octaves` noises with frequency lambda^i and weight omega^i. Generators 2 and 3 may leave [0, 1].
double turbulence(const Vec3& p, int octaves, double lambda, double omega, int generator);
Vec3 vector_turbulence(const Vec3& p, int octaves, double lambda, double omega);

// The fixed octave sums of the patterns granite and wrinkles.
double granite_sum(const Vec3& p, int generator);
double wrinkles_sum(const Vec3& p, int generator);

// The plain, scalar formulas: what the fast versions above are tested against.
namespace reference {
double noise(const Vec3& p, int generator);
Vec3 vector_noise(const Vec3& p);
}  // namespace reference

}  // namespace verisim::textures
