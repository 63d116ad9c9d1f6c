// Noise as the rest of the program sees it: calls into the kernels that fit this machine.
#include "tracer/noise/noise.h"

#include <algorithm>

#include "tracer/noise/noise_kernels.h"

namespace verisim::textures {
namespace {

const NoiseKernels& kernels = noise_kernels(simd::best_instruction_set());

int valid(int generator) { return generator == 1 || generator == 3 ? generator : 2; }

}  // namespace

Octaves::Octaves(int octaves, double lambda, double omega)
    : count(std::clamp(octaves, 1, kMaxOctaves)), scale{}, weight{} {
  double largest = 0, s = 1, w = 1;
  for (int i = 0; i < count; ++i, s *= lambda, w *= omega) {
    scale[i] = s;
    weight[i] = w;
    largest = std::max(largest, std::fabs(s));
  }
  farthest = 1e9 / largest;  // 0 or NaN for a lambda without sense: then every point counts as far
}

double noise(const Vec3& p, int generator) { return kernels.noise[valid(generator)](p); }
void noises(int generator, const EightPoints& points, unsigned wanted, double* noises) {
  kernels.noises[valid(generator)](points, wanted, noises);
}
Vec3 vector_noise(const Vec3& p) { return kernels.vector_noise(p); }
double turbulence(const Vec3& p, const Octaves& octaves, int generator) {
  return kernels.turbulence[valid(generator)](p, octaves);
}
Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves) { return kernels.vector_turbulence(p, octaves); }
double granite_sum(const Vec3& p, int generator) { return kernels.granite[valid(generator)](p); }
double wrinkles_sum(const Vec3& p, int generator) { return kernels.wrinkles[valid(generator)](p); }
Vec3 wrinkles_vector_sum(const Vec3& p) { return kernels.wrinkles_vector(p); }

}  // namespace verisim::textures
