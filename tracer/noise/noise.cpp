// Noise as the rest of the program sees it: calls into the best_noise that fit this machine.
#include "tracer/noise/noise.h"

#include <algorithm>

#include "tracer/noise/noise_kernels.h"

namespace verisim::textures {
namespace {

const NoiseKernels& best_noise = noise_kernels(simd::best_instruction_set());

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

double noise(const Vec3& p, int generator) { return best_noise.noise[valid(generator)](p); }
void noises(int generator, const EightPoints& points, unsigned wanted, double* noises) {
  best_noise.noises[valid(generator)](points, wanted, noises);
}
Vec3 vector_noise(const Vec3& p) { return best_noise.vector_noise(p); }
double turbulence(const Vec3& p, const Octaves& octaves, int generator) {
  return best_noise.turbulence[valid(generator)](p, octaves);
}
Vec3 vector_turbulence(const Vec3& p, const Octaves& octaves) { return best_noise.vector_turbulence(p, octaves); }
double granite_sum(const Vec3& p, int generator) { return best_noise.granite[valid(generator)](p); }
double wrinkles_sum(const Vec3& p, int generator) { return best_noise.wrinkles[valid(generator)](p); }
Vec3 wrinkles_vector_sum(const Vec3& p) { return best_noise.wrinkles_vector(p); }

}  // namespace verisim::textures
