// The evaluation of patterns and pigments as the rest of the program sees it: calls into the kernels that fit this
// machine.
#include "tracer/textures/evaluation/evaluation.h"

#include <algorithm>
#include <cstring>

#include "tracer/textures/evaluation/many_points.h"
#include "tracer/noise/noise.h"

namespace verisim::textures {
namespace {

const EvaluationKernels& kernels = evaluation_kernels(simd::best_instruction_set());

constexpr std::size_t kFewTogether = 3;  // not worth a batch

// std::copy_n for a number of which the compiler knows nothing is a call, or an instruction that takes long to start.
inline __attribute__((always_inline)) void copy_few(const double* from, std::size_t count, double* to) {
  for (; count >= 4; count -= 4, from += 4, to += 4) std::memcpy(to, from, 4 * sizeof *to);
  if (count & 2) std::memcpy(to, from, 2 * sizeof *to), from += 2, to += 2;
  if (count & 1) *to = *from;
}

// Calls values(count, batch, result) for batches of points and copies the result, or single(p) for each point.
template <class Values, class Single>
void in_batches(const double* points, std::size_t stride, std::size_t count, double* result, Values&& values,
                Single&& single) {
  const double *x = points, *y = x + stride, *z = y + stride;
  if (count < kFewTogether) {
    for (std::size_t k = 0; k < count; ++k) result[k] = single(Vec3(x[k], y[k], z[k]));
    return;
  }
  PointBatch batch;
  alignas(64) double found[PointBatch::kMax];
  for (std::size_t begin = 0; begin < count; begin += PointBatch::kMax) {
    const std::size_t n = std::min<std::size_t>(PointBatch::kMax, count - begin);
    copy_few(x + begin, n, batch.x), copy_few(y + begin, n, batch.y), copy_few(z + begin, n, batch.z);
    batch.fill_up(static_cast<int>(n));
    values(static_cast<int>(n), batch, found);
    copy_few(found, n, result + begin);
  }
}

}  // namespace

Vec3 warped(const CompiledPattern& c, const Vec3& p) { return kernels.warped(c, p); }
double value_at(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  return kernels.value_at(c, p, surface);
}
void values_at(const CompiledPattern& c, int count, const PointBatch& points, const SurfacePoint* const* surfaces,
               double* values) {
  kernels.values_batch(c, count, points, surfaces, values);
}
PatternValue value_of(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  return kernels.value_of(c, p, surface);
}
bool evaluate(const CompiledPigment& c, const Vec3& p, const SurfacePoint* surface, Color& color) {
  return kernels.evaluate(c, p, surface, color);
}
void evaluate(const CompiledPigment& c, int count, const PointBatch& points, const SurfacePoint* const* surfaces,
              Color* colors, bool* colored) {
  kernels.evaluate_batch(c, count, points, surfaces, colors, colored);
}
void evaluate(const CompiledPigment& c, int count, const PointBatch& points, RgbBatch& colors) {
  kernels.rgb_batch(c, count, points, colors);
}
double evaluate(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  return kernels.value_of(c, p, surface).value;
}

void evaluate(const CompiledPattern& c, const double* points, std::size_t stride, std::size_t count, double* result) {
  in_batches(
      points, stride, count, result,
      [&](int n, const PointBatch& batch, double* values) {
        PointBatch warped;
        kernels.warp_batch(c.chain, n, batch, warped);
        kernels.values_batch(c, n, warped, nullptr, values);
      },
      [&](const Vec3& p) { return evaluate(c, p, nullptr); });
}
void noise(int generator, const double* points, std::size_t stride, std::size_t count, double* result) {
  in_batches(
      points, stride, count, result,
      [&](int n, const PointBatch& batch, double* values) { kernels.noise_batch(generator, n, batch, values); },
      [&](const Vec3& p) { return noise(p, generator); });
}

void turbulence(int generator, int count, const PointBatch& points, const Octaves& octaves, double* values) {
  kernels.turbulence_batch(generator, count, points, octaves, values);
}

}  // namespace verisim::textures
