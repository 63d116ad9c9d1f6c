#include "tracer/photons/photon.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/constants.h"

namespace verisim::global {

static_assert(sizeof(Photon) == 7 && sizeof(PhotonPosition) == 12);

void PhotonList::fit() {
  positions.set_capacity(size() + kBehind), photons.set_capacity(size());
  std::fill_n(positions.end(), kBehind, PhotonPosition{});
}

std::array<std::uint8_t, 4> Photon::encode(const Rgb& energy) {
  const float v = energy.max();
  if (std::isnan(v)) return {0, 0, 0, 250};  // of a packet that media left nothing known of (spec 07 3.8)
  if (!(v >= 1e-32f)) return {0, 0, 0, 0};
  int exponent;
  const double scale = std::frexp(static_cast<double>(v), &exponent) * 256.0 / v;
  const auto mantissa = [&](float c) {
    return static_cast<std::uint8_t>(std::clamp(static_cast<int>(c * scale), 0, 255));
  };
  return {mantissa(energy.r), mantissa(energy.g), mantissa(energy.b), static_cast<std::uint8_t>(exponent + 250)};
}

void Photon::set_direction(const Vec3& d) {
  const double horizontal = std::sqrt(d.x * d.x + d.z * d.z);
  double up = std::acos(std::clamp(horizontal, -1.0, 1.0));
  if (d.y < 0.0) up = -up;
  double around = horizontal > 0.0 ? std::acos(std::clamp(d.x / horizontal, -1.0, 1.0)) : 0.0;
  if (d.z < 0.0) around = -around;
  elevation = static_cast<std::int8_t>(up * 127.0 / kPi);
  azimuth = static_cast<std::int8_t>(around * 127.0 / kPi);
}

const std::array<float, 256> Photon::kScales = [] {
  std::array<float, 256> t;
  for (int e = 0; e < 256; ++e) t[static_cast<std::size_t>(e)] = e == 0 ? 0.0f : std::ldexp(1.0f, e - (250 + 8));
  return t;
}();

const std::array<Photon::Angle, 256> Photon::kAngles = [] {
  std::array<Angle, 256> t;
  for (int i = 0; i < 256; ++i) {
    const double angle = static_cast<std::int8_t>(i) * kPi / 127.0;
    t[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
  }
  return t;
}();

}  // namespace verisim::global
