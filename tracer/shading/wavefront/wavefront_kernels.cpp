#include "tracer/shading/wavefront/wavefront_kernels.h"
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shading/wavefront/wavefront_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/math/power.h"
#include "tracer/shading/finish.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shading {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr int rounded(int count) {
  return (count + WavefrontPacket::kStep - 1) / WavefrontPacket::kStep * WavefrontPacket::kStep;
}

void directions(const PerspectiveView& view, const Vec2* places, int count, WavefrontPacket& packet) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i)
    packet.rays.direction.set(i, normalize(view.through(view.place(places[i].x, places[i].y))));
}

void face(int count, WavefrontPacket& packet) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i)
    packet.cosine[i] = packet.normal.x[i] * packet.to_light.direction.x[i] +
                       packet.normal.y[i] * packet.to_light.direction.y[i] +
                       packet.normal.z[i] * packet.to_light.direction.z[i];
}

float largest(float r, float g, float b) {
  const float x = std::fabs(r), y = std::fabs(g), z = std::fabs(b), m = x < y ? y : x;
  return m < z ? z : m;
}

bool receive(const Rgb& light, bool highlights, int count, WavefrontPacket& packet) {
  const float r = light.r, g = light.g, b = light.b;
  const double shining = highlights ? 1 : 0;
  std::int32_t any = 0;
  for (int i = 0; i < count; ++i) {
    const double a = packet.attenuation[i];
    packet.intensity.r[i] = static_cast<float>(r * a), packet.intensity.g[i] = static_cast<float>(g * a),
    packet.intensity.b[i] = static_cast<float>(b * a);
  }
  for (int i = 0; i < count; ++i) {
    const bool back = (packet.cosine[i] < kEpsilon) & (packet.two_sided[i] == 0);
    packet.diffuse[i] = back ? packet.behind[i] : packet.front[i];
    packet.shines[i] = back ? 0 : shining;
    const bool dark = largest(packet.intensity.r[i], packet.intensity.g[i], packet.intensity.b[i]) < kDark;
    const std::int32_t active = ((back & (packet.lit_behind[i] == 0)) | (packet.dull[i] != 0) | dark) ? 0 : 1;
    packet.active[i] = active;
    any |= active;
  }
  return any != 0;
}

bool illuminate(int count, WavefrontPacket& packet) {
  std::int32_t any = 0;
  for (int i = 0; i < count; ++i) {
    const bool bright = largest(packet.intensity.r[i], packet.intensity.g[i], packet.intensity.b[i]) > kDark;
    const std::int32_t lit = ((packet.active[i] != 0) & bright) ? 1 : 0;
    packet.lit[i] = static_cast<float>(lit);
    any |= lit;
  }
  return any != 0;
}

// The cosines that highlights are powers of; 0 where they are dark.
void highlight_bases(bool phong, bool blinn, int end, WavefrontPacket& packet, double* base) {
  for (int i = 0; i < end; ++i) base[i] = 0;
  if (blinn)
    for (int i = 0; i < end; ++i)
      base[i] = blinn_cosine(packet.normal.at(i), packet.view.at(i), packet.to_light.direction.at(i));
  if (phong)
    for (int i = 0; i < end; ++i) {
      const double m = phong_cosine(packet.normal.at(i), packet.view.at(i), packet.to_light.direction.at(i));
      base[i] = packet.phong[i] != 0 ? m : base[i];
    }
  for (int i = 0; i < end; ++i) base[i] = base[i] <= packet.dark_to[i] ? 0 : base[i];
}

// amount * base^exponent, for its product with the tinted intensity in single precision. The power is computed to more
// digits than binary32 has; where its error might change the rounding, `uncertain` says so (Ziv, "Fast evaluation of
// elementary mathematical functions with correctly rounded last bit", 1991).
std::int32_t raise(int end, const double* base, WavefrontPacket& packet) {
  constexpr double kSmallest = -690;  // of a logarithm: binary32 has 0 long before
  constexpr double kError = 0x1p-39;  // of the power, relative: 2e-12; that of the logarithm is below 1e-15 times 690
  std::int32_t any = 0;
  for (int i = 0; i < end; ++i) {
    const double m = base[i];
    const bool bright = m >= 0x1p-1000;
    const double t = packet.exponent[i] * power::logarithm<11>(bright ? m : 1.0);
    const bool in_range = t > kSmallest && t < 600;
    const double raised = power::exponential(in_range ? t : 0);
    const double value = packet.amount[i] * packet.shines[i] * (bright && in_range ? raised : 0);
    const double low = value - value * kError, high = value + value * kError;
    const auto same = [low, high](double light) {
      return static_cast<float>(low * light) == static_cast<float>(high * light);
    };
    packet.strength[i] = value;
    // What is darker than the smallest numbers is 0; what is dark on purpose, too.
    const bool known = same(packet.intensity.r[i] * packet.tint.r[i]) & same(packet.intensity.g[i] * packet.tint.g[i]) &
                       same(packet.intensity.b[i] * packet.tint.b[i]) & (in_range | (t <= kSmallest)) &
                       (bright | (m <= 0));
    packet.uncertain[i] = known ? 0 : 1;
    any |= known ? 0 : 1;
  }
  return any;
}

bool evaluate_lobes(bool phong, bool blinn, int count, WavefrontPacket& packet) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) packet.scattered[i] = packet.diffuse[i] * brilliance(1, packet.cosine[i]);
  if (!phong && !blinn) {
    for (int i = 0; i < end; ++i) packet.strength[i] = 0;
    return false;
  }
  alignas(64) double base[WavefrontPacket::kMax];
  highlight_bases(phong, blinn, end, packet, base);
  return raise(end, base, packet) != 0;
}

template <bool kSecond>
void add_channel(int end, const WavefrontPacket& packet, const float* pigment, const float* intensity,
                 const float* tint, const float* film, float* direct) {
  for (int i = 0; i < end; ++i) {
    const float shining = intensity[i] * tint[i];
    float added = static_cast<float>(packet.scattered[i] * pigment[i]) * intensity[i] +
                  static_cast<float>(packet.strength[i] * shining);
    if constexpr (kSecond) added += static_cast<float>(packet.second[i] * shining);
    direct[i] = packet.lit[i] != 0 ? direct[i] + added * film[i] : direct[i];
  }
}

template <bool kSecond>
void add_light(int end, WavefrontPacket& packet) {
  add_channel<kSecond>(end, packet, packet.pigment.r, packet.intensity.r, packet.tint.r, packet.film.r,
                       packet.direct.r);
  add_channel<kSecond>(end, packet, packet.pigment.g, packet.intensity.g, packet.tint.g, packet.film.g,
                       packet.direct.g);
  add_channel<kSecond>(end, packet, packet.pigment.b, packet.intensity.b, packet.tint.b, packet.film.b,
                       packet.direct.b);
}

void add(bool second, int count, WavefrontPacket& packet) {
  if (second)
    add_light<true>(rounded(count), packet);
  else
    add_light<false>(rounded(count), packet);
}

const WavefrontKernels kKernels = {directions, face, receive, illuminate, evaluate_lobes, add};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shading
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shading {
VERISIM_EXPORT_KERNELS(WavefrontKernels, wavefront_kernels)
}  // namespace verisim::shading
#endif
