#include "tracer/textures/normals/normal_kernels.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/textures/normals/normal_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::textures {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr int rounded(int count) { return (count + 7) / 8 * 8; }

// As `normalize`, by the reciprocal.
void to_units(int end, PointBatch& n) {
  for (int i = 0; i < end; ++i) {
    const double x = n.x[i], y = n.y[i], z = n.z[i];
    const double scale = 1 / std::sqrt(x * x + y * y + z * z);
    n.x[i] = x * scale;
    n.y[i] = y * scale;
    n.z[i] = z * scale;
  }
}

void transform_by_transposed(const Affine& a, int end, PointBatch& n) {
  const double xx = a[0][0], xy = a[0][1], xz = a[0][2], yx = a[1][0], yy = a[1][1], yz = a[1][2], zx = a[2][0],
               zy = a[2][1], zz = a[2][2];
  for (int i = 0; i < end; ++i) {
    const double x = n.x[i], y = n.y[i], z = n.z[i];
    n.x[i] = x * xx + y * xy + z * xz;
    n.y[i] = x * yx + y * yy + z * yz;
    n.z[i] = x * zx + y * zy + z * zz;
  }
}

void into_frame(const CompiledPattern& pattern, bool no_bump_scale, int count, PointBatch& n) {
  const int end = rounded(count);
  if (!no_bump_scale) to_units(end, n);
  for (const Transform& t : pattern.frame) transform_by_transposed(t.m, end, n);
  if (!no_bump_scale) to_units(end, n);
}

void out_of_frame(const CompiledPattern& pattern, bool no_bump_scale, int count, PointBatch& n) {
  const int end = rounded(count);
  if (!no_bump_scale) to_units(end, n);
  for (std::size_t k = pattern.frame.size(); k-- > 0;) transform_by_transposed(pattern.frame[k].inv, end, n);
  if (!no_bump_scale) to_units(end, n);
}

void displace(double amount, int count, const PointBatch& v, PointBatch& n) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) {
    n.x[i] += amount * v.x[i];
    n.y[i] += amount * v.y[i];
    n.z[i] += amount * v.z[i];
  }
}

void scale_by_cubes(double amount, int count, const double* f, PointBatch& v) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) {
    const double cube = f[i] * f[i] * f[i] * amount;
    v.x[i] *= cube;
    v.y[i] *= cube;
    v.z[i] *= cube;
  }
}

void raise(const double* heights, double strength, const Vec3& direction, int count, PointBatch& n) {
  const int end = rounded(count);
  const double dx = direction.x, dy = direction.y, dz = direction.z;
  for (int i = 0; i < end; ++i) {
    const double height = heights[i] * strength;
    n.x[i] += height * dx;
    n.y[i] += height * dy;
    n.z[i] += height * dz;
  }
}

void wave_angles(const WaveSource& source, const SourceWave& wave, int count, const PointBatch& p, double* distances,
                 double* angles) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) {
    distances[i] = wave_distance(source, p.at(i));
    angles[i] = sine_angle(wave.cycles(distances[i]));
  }
}

void add_wave(const WaveSource& source, const SourceWave& wave, int count, const PointBatch& p, const double* distances,
              const double* sines, PointBatch& n) {
  const int end = rounded(count);
  const Vec3 from = source.position;
  for (int i = 0; i < end; ++i) {
    const double slope = wave.slope(sines[i], distances[i]);
    n.x[i] += slope * (p.x[i] - from.x);
    n.y[i] += slope * (p.y[i] - from.y);
    n.z[i] += slope * (p.z[i] - from.z);
  }
}

void move(const PointBatch& p, double factor, const Vec3& direction, int count, PointBatch& moved) {
  const int end = rounded(count);
  const double dx = factor * direction.x, dy = factor * direction.y, dz = factor * direction.z;
  for (int i = 0; i < end; ++i) {
    moved.x[i] = p.x[i] + dx;
    moved.y[i] = p.y[i] + dy;
    moved.z[i] = p.z[i] + dz;
  }
}

const NormalKernels kKernels = {into_frame, out_of_frame, displace, scale_by_cubes, raise, wave_angles, add_wave, move};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::textures
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::textures {
VERISIM_EXPORT_KERNELS(NormalKernels, normal_kernels)
}  // namespace verisim::textures
#endif
