// A stored photon (spec 07 section 3.7).
//
// It keeps what POV-Ray's keeps: binary32 position, a shared-exponent colour and a direction in two signed bytes; the
// rounding shows in pictures.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tracer/math/color.h"
#include "tracer/math/vec.h"

namespace verisim::global {

struct Photon {
  std::array<float, 3> position;
  std::array<std::uint8_t, 4> energy;  // mantissas and exponent + 250
  std::uint8_t axis = 0;               // of the tree node
  std::int8_t elevation = 0, azimuth = 0;

  static std::array<std::uint8_t, 4> encode(const Rgb& energy);
  void set_direction(const Vec3& towards_light);  // unit
  Rgb color() const;
  float scale() const { return kScales[energy[3]]; }  // of its mantissas
  Vec3 direction() const;

 private:
  struct Angle {
    double cosine, sine;
  };
  static const std::array<float, 256> kScales;
  static const std::array<Angle, 256> kAngles;
};

// Some photons of a map.
struct SomePhotons {
  std::span<const Photon> map;
  std::span<const std::uint32_t> numbers;
  bool empty() const { return numbers.empty(); }
  std::size_t size() const { return numbers.size(); }
  const Photon& operator[](std::size_t i) const { return map[numbers[i]]; }
};

inline Rgb Photon::color() const {
  const float scale = this->scale();
  return {energy[0] * scale, energy[1] * scale, energy[2] * scale};
}

inline Vec3 Photon::direction() const {
  const Angle &up = kAngles[static_cast<std::uint8_t>(elevation)],
              &around = kAngles[static_cast<std::uint8_t>(azimuth)];
  return {up.cosine * around.cosine, up.sine, up.cosine * around.sine};
}

}  // namespace verisim::global
