// Which of many irradiance samples may reach a query (spec 07 2.5), eight at a time. Floats sort out, with margins for
// their rounding. Compiled for several instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tracer/math/vec.h"

namespace verisim::global {

// Eight samples; unused places are far from everywhere.
struct alignas(32) IrradiancePacket {
  static constexpr std::uint32_t kCount = 8;
  float point[3][kCount], normal[3][kCount];  // points relative to some centre
  float mean_distance[kCount], widest[kCount];
  std::uint32_t entry[kCount], sample[kCount];  // numbers, for whoever asks
};

struct IrradianceQuery {
  Vec3 point, normal;  // the point relative to the same centre
  double bound;        // of the error
  double farthest;     // no coordinate of a sample or of the query is larger
};

struct IrradianceKernels {
  // Writes the numbers of the samples whose distance r is below bound * mean_distance, and r / widest + 2 sqrt(1 -
  // cosine of the normals) below bound, and of some more, in their order. Returns how many; there is room for all.
  std::size_t (*near)(const IrradiancePacket* packet, std::size_t count, const IrradianceQuery& query,
                      std::uint32_t* samples);
};

const IrradianceKernels& irradiance_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const IrradianceKernels* irradiance_kernels(int instruction_set);

}  // namespace verisim::global
