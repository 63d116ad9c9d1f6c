// A stored photon (spec 07 section 3.7).
//
// It keeps what POV-Ray's keeps: binary32 position, a shared-exponent colour and a direction in two signed bytes; the
// rounding shows in pictures. Positions are stored apart, because searches read nothing else of the many that they
// pass.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tracer/base/realloc_vector.h"
#include "tracer/math/color.h"
#include "tracer/math/vec.h"

namespace verisim::global {

using PhotonPosition = std::array<float, 3>;

// What it carries.
struct Photon {
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

// Photons by number, which grow by one after another or all at once.
struct PhotonList {
  ReallocVector<PhotonPosition> positions;
  ReallocVector<Photon> photons;

  std::size_t size() const { return photons.size(); }
  bool empty() const { return photons.empty(); }
  void add(const PhotonPosition& position, const Photon& photon) {
    positions.push_back(position), photons.push_back(photon);
  }
  void append(const PhotonList& other) { positions.append(other.positions), photons.append(other.photons); }
  void reserve(std::size_t count) { positions.reserve(count + kBehind), photons.reserve(count); }
  // Gives back what is not needed, but for positions behind the last one, which kernels may read.
  void fit();
  static constexpr std::size_t kBehind = 16;
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
