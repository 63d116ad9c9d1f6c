#include "tracer/radiosity/irradiance_weights.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/radiosity/irradiance_weight_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

void weigh(const IrradianceWeightQuery& query, int count, IrradianceBatch& batch) {
  const double nx = query.normal.x, ny = query.normal.y, nz = query.normal.z, bound = query.bound;
  const double smooth = query.smooth ? 1 : 0;
  const auto& d = batch.delta;
  const auto& n = batch.normal;
  const auto& near = batch.nearest_direction;
  const int end = (count + IrradianceBatch::kStep - 1) / IrradianceBatch::kStep * IrradianceBatch::kStep;
  for (int i = 0; i < end; ++i) {
    const double r = std::sqrt(batch.squared[i]), mean = batch.mean_distance[i];
    const bool apart = r > 1e-6;
    const double divisor = apart ? r : 1.0;
    const double ux = d.x[i] / divisor, uy = d.y[i] / divisor, uz = d.z[i] / divisor;
    const double c = ux * near.x[i] + uy * near.y[i] + uz * near.z[i];
    const double towards = c * batch.nearest_distance[i] + (1.0 - c) * mean;
    const double nearer = c > 0.0 ? towards : mean, radius = apart ? nearer : mean;
    const double turn = std::fabs(1.0 - (nx * n.x[i] + ny * n.y[i] + nz * n.z[i]));
    const double error = r / radius + 2.0 * std::sqrt(turn);
    const double mx = nx + n.x[i], my = ny + n.y[i], mz = nz + n.z[i];
    const double inverse = 1 / std::sqrt(mx * mx + my * my + mz * mz);
    const double along = ux * (mx * inverse) + uy * (my * inverse) + uz * (mz * inverse);
    const double facing = apart ? along : 1.0;  // no number where the normals are opposite
    const double t = error / bound, plain = 1.0 - t;
    const double inner = 1.0 - 2.0 * t * t, outer = 2.0 * plain * plain, round = t < 0.5 ? inner : outer;
    const double straight = smooth != 0 ? round : plain;
    double weight = facing <= 0.0 ? straight * (1.0 + 20.0 * facing) : straight;
    const double within = apart ? radius * bound : 1e300;
    weight = r >= within ? 0.0 : weight;
    weight = error < bound ? weight : 0.0;
    batch.weight[i] = facing > -0.05 ? weight : 0.0;
  }
}

constexpr IrradianceWeightKernels kKernels = {weigh};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::global {
VERISIM_EXPORT_KERNELS(IrradianceWeightKernels, irradiance_weight_kernels)
}  // namespace verisim::global
#endif
