// What the fast noise remembers of the lattice cells it has met.
//
// Inside one lattice cell, noise is  sum over the 8 corners of  w_c (a_c + b_c f_x + c_c f_y + d_c f_z),  f the place
// within the cell and w the smooth trilinear weights. Neighbouring samples of a picture share cells, so each thread
// keeps the coefficients of recent cells; what remains to be done for a sample is arithmetic on whole vectors. The
// memory changes the speed only: a cell's contents depend on nothing but the cell.
#pragma once

#include <cstdint>

#include "tracer/noise/noise_tables.h"

namespace verisim::textures {

// Coefficients of the corners; corner index = 4 c_x + 2 c_y + c_z.
struct alignas(64) NoiseCell {
  double a[8], b[8], c[8], d[8];
};
// Direct-mapped memory of cells. Only the low 12 bits of lattice coordinates matter (11 for the gradient noise of
// generator 3). The low bits of x follow from slot, y and z, so a slot and a key of 29 bits name a cell. No key is 0.
constexpr std::uint32_t kNoiseSlots =
    512;  // an eighth of a megabyte: a part of the second-level cache, which the rest of the program needs as well
template <std::uint32_t slots>
constexpr std::uint32_t cell_slot(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return (x + 37 * y + 331 * z) % slots;
}
constexpr std::uint32_t kLatticeKey = 1u << 27, kGradientKey = 3u << 27;
constexpr std::uint32_t cell_key(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return (x >> 9 & 7) | (y & 4095) << 3 | (z & 4095) << 15;
}
static_assert(kNoiseSlots % 512 == 0);

template <class Cell, std::uint32_t slots>
struct CellMemory {
  std::uint32_t keys[slots] = {};
  Cell cells[slots];
};
using ScalarMemory = CellMemory<NoiseCell, kNoiseSlots>;

struct NoiseMemory {
  ScalarMemory scalar;
};

// The memory of the calling thread; made when it is first asked for.
extern thread_local constinit NoiseMemory* thread_noise_memory __attribute__((tls_model("initial-exec")));
NoiseMemory& make_thread_noise_memory();
inline NoiseMemory& noise_memory() {
  if (thread_noise_memory) [[likely]]
    return *thread_noise_memory;
  return make_thread_noise_memory();
}

}  // namespace verisim::textures
