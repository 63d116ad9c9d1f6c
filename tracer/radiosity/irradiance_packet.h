// Which of many irradiance samples may reach a query (spec 07 2.5), eight at a time. Compiled for several instruction
// sets. A sample is listed wherever it may be found, some ten to twenty times, so it is listed in 20 bytes: rounded
// numbers sort out, with margins for their rounding.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "tracer/math/vec.h"

namespace verisim::global {

// The upper sixteen bits behind the sign of x >= 0, or of the next larger number that has no more.
inline constexpr int kLowerBits = 15;
inline std::uint16_t upper_half_above(float x) {
  return static_cast<std::uint16_t>((std::bit_cast<std::uint32_t>(x) + ((1u << kLowerBits) - 1)) >> kLowerBits);
}

// A sample as it is filed: its point relative to the centre of the list it is in, and in the unit of that.
struct FiledSample {
  Vec3 point, normal;
  float mean_distance, widest;
  std::uint32_t number;  // for whoever asks
};

// Eight samples.
struct alignas(32) IrradiancePacket {
  static constexpr std::uint32_t kCount = 8;
  static constexpr double kScale = 32767;  // the largest coordinate of a point; the length of normals
  void set(std::uint32_t lane, const FiledSample& from) {
    for (int a = 0; a < 3; ++a) {
      point[a][lane] = static_cast<std::int16_t>(std::lround(from.point[a]));
      normal[a][lane] = static_cast<std::int16_t>(std::lround(from.normal[a] * kScale));
    }
    mean_distance[lane] = upper_half_above(from.mean_distance), widest[lane] = upper_half_above(from.widest);
    sample[lane] = from.number;
  }

  // Points in a unit of twice the size: off by less than one of it, however often.
  void double_unit() {
    for (auto& axis : point) {
      for (std::int16_t& x : axis) x = static_cast<std::int16_t>((x + 1) >> 1);
    }
  }

  std::int16_t point[3][kCount] = {}, normal[3][kCount] = {};
  std::uint16_t mean_distance[kCount], widest[kCount];
  std::uint32_t sample[kCount] = {};
};

struct IrradianceQuery {
  Vec3 point, normal;  // the point relative to the same centre
  double bound;        // of the error
  double unit;         // of the samples' points
};

struct IrradianceKernels {
  // Writes the numbers of the samples whose distance r is below bound * mean_distance, and r / widest + 2 sqrt(1 -
  // cosine of the normals) below bound, and of some more, in their order. Returns how many; there is room for all
  // `count` that are in the packets.
  std::size_t (*near)(const IrradiancePacket* packets, std::size_t count, const IrradianceQuery& query,
                      std::uint32_t* samples);
};

const IrradianceKernels& irradiance_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const IrradianceKernels* irradiance_kernels(int instruction_set);

}  // namespace verisim::global
