#include "tracer/shading/wavefront/wave_kernels.h"
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shading/wavefront/wave_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shading {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr float kDark = static_cast<float>(kEpsilon);

constexpr int rounded(int count) { return (count + WaveLanes::kStep - 1) / WaveLanes::kStep * WaveLanes::kStep; }

void directions(const WaveCamera& camera, const Vec2* places, int count, WaveLanes& lanes) {
  const Vec3 &d = camera.direction, &r = camera.right, &u = camera.up;
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) {
    const double uc = (places[i].x + 0.5) / camera.width - 0.5,
                 wc = (camera.height - (places[i].y + 0.5)) / camera.height - 0.5;
    const double vx = d.x + uc * r.x + wc * u.x, vy = d.y + uc * r.y + wc * u.y, vz = d.z + uc * r.z + wc * u.z;
    const double inverse = 1 / std::sqrt(vx * vx + vy * vy + vz * vz);
    lanes.rays.direction.x[i] = vx * inverse;
    lanes.rays.direction.y[i] = vy * inverse;
    lanes.rays.direction.z[i] = vz * inverse;
  }
}

void face(int count, WaveLanes& lanes) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i)
    lanes.cosine[i] = lanes.normal.x[i] * lanes.to_light.direction.x[i] +
                      lanes.normal.y[i] * lanes.to_light.direction.y[i] +
                      lanes.normal.z[i] * lanes.to_light.direction.z[i];
}

float largest(float r, float g, float b) {
  const float x = std::fabs(r), y = std::fabs(g), z = std::fabs(b), m = x < y ? y : x;
  return m < z ? z : m;
}

bool receive(const Rgb& light, bool highlights, int count, WaveLanes& lanes) {
  const float r = light.r, g = light.g, b = light.b;
  const double shining = highlights ? 1 : 0;
  std::int32_t any = 0;
  for (int i = 0; i < count; ++i) {
    const float a = lanes.attenuation[i];
    lanes.intensity.r[i] = r * a, lanes.intensity.g[i] = g * a, lanes.intensity.b[i] = b * a;
  }
  for (int i = 0; i < count; ++i) {
    const bool back = (lanes.cosine[i] < kEpsilon) & (lanes.two_sided[i] == 0);
    lanes.diffuse[i] = back ? lanes.behind[i] : lanes.front[i];
    lanes.shines[i] = back ? 0 : shining;
    const bool dark = largest(lanes.intensity.r[i], lanes.intensity.g[i], lanes.intensity.b[i]) < kDark;
    const std::int32_t asked = (back & (lanes.lit_behind[i] == 0)) | (lanes.dull[i] != 0) | dark ? 0 : 1;
    lanes.asked[i] = asked;
    any |= asked;
  }
  return any != 0;
}

bool illuminate(int count, WaveLanes& lanes) {
  std::int32_t any = 0;
  for (int i = 0; i < count; ++i) {
    const bool bright = largest(lanes.intensity.r[i], lanes.intensity.g[i], lanes.intensity.b[i]) > kDark;
    const std::int32_t lit = (lanes.asked[i] != 0) & bright ? 1 : 0;
    lanes.lit[i] = static_cast<float>(lit);
    any |= lit;
  }
  return any != 0;
}

// The cosines that highlights are powers of; 0 where they are dark.
void highlight_bases(bool phong, bool blinn, int end, WaveLanes& lanes, double* base) {
  for (int i = 0; i < end; ++i) base[i] = 0;
  if (blinn) {
    for (int i = 0; i < end; ++i) {
      const double x = (lanes.to_light.direction.x[i] - lanes.view.x[i]) * 0.5,
                   y = (lanes.to_light.direction.y[i] - lanes.view.y[i]) * 0.5,
                   z = (lanes.to_light.direction.z[i] - lanes.view.z[i]) * 0.5;
      const double size = std::sqrt(x * x + y * y + z * z);
      const double m = (x * lanes.normal.x[i] + y * lanes.normal.y[i] + z * lanes.normal.z[i]) / size;
      base[i] = size <= 0 ? 0 : m;
    }
  }
  if (phong) {
    for (int i = 0; i < end; ++i) {
      const double twice = 2 * (lanes.view.x[i] * lanes.normal.x[i] + lanes.view.y[i] * lanes.normal.y[i] +
                                lanes.view.z[i] * lanes.normal.z[i]);
      const double x = lanes.view.x[i] - lanes.normal.x[i] * twice, y = lanes.view.y[i] - lanes.normal.y[i] * twice,
                   z = lanes.view.z[i] - lanes.normal.z[i] * twice;
      const double m =
          x * lanes.to_light.direction.x[i] + y * lanes.to_light.direction.y[i] + z * lanes.to_light.direction.z[i];
      base[i] = lanes.phong[i] != 0 ? m : base[i];
    }
  }
  for (int i = 0; i < end; ++i) base[i] = base[i] <= lanes.base_limit[i] ? 0 : base[i];
}

// amount * base^exponent in single precision. The power is computed to more digits than binary32 has; where its error
// might change the rounding, `uncertain` says so (Ziv, "Fast evaluation of elementary mathematical functions with
// correctly rounded last bit", 1991).
std::int32_t raise(int end, const double* base, WaveLanes& lanes) {
  constexpr double kLn2High = 0x1.62e42fefa3800p-1,
                   kLn2Low = 0x1.ef35793c76730p-45;  // the product of the first with a small integer is exact
  constexpr double kShift = 0x1.8p52;                // what is added to it loses its fraction
  constexpr double kSmallest = -690;                 // of a logarithm: binary32 has 0 long before
  constexpr double kError = 0x1p-39;  // of the power, relative: 2e-12; that of the logarithm is below 1e-15 times 690
  std::int32_t any = 0;
  for (int i = 0; i < end; ++i) {
    const double m = base[i];
    const bool bright = m >= 0x1p-1000;
    const auto bits = std::bit_cast<std::int64_t>(bright ? m : 1.0);
    // m = 2^e * f with f between the roots of 1/2 and 2.
    const std::int64_t e = (bits - 0x3fe6a09e667f3bcd) >> 52;
    const double f = std::bit_cast<double>(bits - (e << 52));
    const double n = std::bit_cast<double>(e + std::bit_cast<std::int64_t>(kShift)) - kShift;
    // log f = 2 atanh s
    const double s = (f - 1) / (f + 1), z = s * s;
    double p = 1.0 / 23;
    p = p * z + 1.0 / 21;
    p = p * z + 1.0 / 19;
    p = p * z + 1.0 / 17;
    p = p * z + 1.0 / 15;
    p = p * z + 1.0 / 13;
    p = p * z + 1.0 / 11;
    p = p * z + 1.0 / 9;
    p = p * z + 1.0 / 7;
    p = p * z + 1.0 / 5;
    p = p * z + 1.0 / 3;
    const double log_f = 2 * s + 2 * s * z * p;
    const double t = lanes.exponent[i] * (n * kLn2High + (n * kLn2Low + log_f));
    const bool in_range = t > kSmallest && t < 600;
    const double u = in_range ? t : 0;
    const double shifted = u * 0x1.71547652b82fep0 + kShift, k = shifted - kShift;  // u / ln 2, rounded
    const double r = (u - k * kLn2High) - k * kLn2Low;
    double q = 1.0 / 6227020800;
    q = q * r + 1.0 / 479001600;
    q = q * r + 1.0 / 39916800;
    q = q * r + 1.0 / 3628800;
    q = q * r + 1.0 / 362880;
    q = q * r + 1.0 / 40320;
    q = q * r + 1.0 / 5040;
    q = q * r + 1.0 / 720;
    q = q * r + 1.0 / 120;
    q = q * r + 1.0 / 24;
    q = q * r + 1.0 / 6;
    q = q * r + 0.5;
    q = q * r + 1;
    q = q * r + 1;
    const double power =
        std::bit_cast<double>(std::bit_cast<std::int64_t>(q) + (std::bit_cast<std::int64_t>(shifted) << 52));
    const double value = lanes.amount[i] * lanes.shines[i] * (bright && in_range ? power : 0);
    const auto low = static_cast<float>(value - value * kError), high = static_cast<float>(value + value * kError);
    lanes.strength[i] = low;
    // What is darker than the smallest numbers is 0; what is dark on purpose, too.
    const bool known = low == high && (in_range || t <= kSmallest) && (bright || m <= 0);
    lanes.uncertain[i] = known ? 0 : 1;
    any |= known ? 0 : 1;
  }
  return any;
}

bool respond(bool phong, bool blinn, int count, WaveLanes& lanes) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) lanes.scattered[i] = static_cast<float>(lanes.diffuse[i] * std::fabs(lanes.cosine[i]));
  if (!phong && !blinn) {
    for (int i = 0; i < end; ++i) lanes.strength[i] = 0;
    return false;
  }
  alignas(64) double base[WaveLanes::kMost];
  highlight_bases(phong, blinn, end, lanes, base);
  return raise(end, base, lanes) != 0;
}

void add_channel(int end, const WaveLanes& lanes, const float* pigment, const float* intensity, const float* tint,
                 float* direct) {
  for (int i = 0; i < end; ++i) {
    const float added = lanes.scattered[i] * pigment[i] * intensity[i] + intensity[i] * lanes.strength[i] * tint[i];
    direct[i] = lanes.lit[i] != 0 ? direct[i] + added : direct[i];
  }
}

void add(int count, WaveLanes& lanes) {
  const int end = rounded(count);
  add_channel(end, lanes, lanes.pigment.r, lanes.intensity.r, lanes.tint.r, lanes.direct.r);
  add_channel(end, lanes, lanes.pigment.g, lanes.intensity.g, lanes.tint.g, lanes.direct.g);
  add_channel(end, lanes, lanes.pigment.b, lanes.intensity.b, lanes.tint.b, lanes.direct.b);
}

void add_own(int count, WaveLanes& lanes) {
  const int end = rounded(count);
  const auto channel = [end](const float* own, float* direct) {
    for (int i = 0; i < end; ++i) direct[i] = own[i] + direct[i];
  };
  channel(lanes.own.r, lanes.direct.r);
  channel(lanes.own.g, lanes.direct.g);
  channel(lanes.own.b, lanes.direct.b);
}

const WaveKernels kKernels = {directions, face, receive, illuminate, respond, add, add_own};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shading
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shading {
VERISIM_EXPORT_KERNELS(WaveKernels, wave_kernels)
}  // namespace verisim::shading
#endif
