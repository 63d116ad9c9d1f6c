#include "tracer/shapes/heights/height_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "tracer/shapes/heights/height_packet.h"
#include "tracer/simd/instruction_sets.h"

#define VERISIM_INLINE inline __attribute__((always_inline))
#pragma GCC diagnostic ignored "-Wpsabi"          // vectors are only passed between functions that are inlined
#pragma GCC diagnostic ignored "-Wuninitialized"  // GCC 12 reports its own intrinsics

namespace verisim::shapes {
namespace {

#define VERISIM_INSTRUCTION_SET 0
namespace baseline {
#if defined(__x86_64__)
using Register = __m128;
VERISIM_INLINE Register broadcast(float v) { return _mm_set1_ps(v); }
VERISIM_INLINE Register load(const float* p) { return _mm_load_ps(p); }
VERISIM_INLINE Register load(const std::uint16_t* p) {
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)), _mm_setzero_si128()));
}
VERISIM_INLINE void store(float* p, Register v) { _mm_store_ps(p, v); }
VERISIM_INLINE Register smaller(Register a, Register b) { return _mm_min_ps(a, b); }
VERISIM_INLINE Register larger(Register a, Register b) { return _mm_max_ps(a, b); }
VERISIM_INLINE unsigned at_most(Register a, Register b) {
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(a, b)));
}
#else
using Register = float __attribute__((vector_size(16)));
VERISIM_INLINE Register broadcast(float v) { return Register{v, v, v, v}; }
VERISIM_INLINE Register load(const float* p) { return Register{p[0], p[1], p[2], p[3]}; }
VERISIM_INLINE Register load(const std::uint16_t* p) {
  return Register{float(p[0]), float(p[1]), float(p[2]), float(p[3])};
}
VERISIM_INLINE void store(float* p, Register v) { std::copy_n(&v[0], 4, p); }
VERISIM_INLINE Register smaller(Register a, Register b) { return a < b ? a : b; }
VERISIM_INLINE Register larger(Register a, Register b) { return a > b ? a : b; }
VERISIM_INLINE unsigned at_most(Register a, Register b) {
  unsigned bits = 0;
  for (unsigned k = 0; k < 4; ++k) bits |= static_cast<unsigned>(a[k] <= b[k]) << k;
  return bits;
}
#endif
#include "tracer/shapes/heights/height_walk.inc"
#include "tracer/shapes/heights/height_packet.inc"
}  // namespace baseline
#undef VERISIM_INSTRUCTION_SET

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi,bmi2")
#define VERISIM_INSTRUCTION_SET 1
namespace avx2 {
using Register = __m256;
VERISIM_INLINE Register broadcast(float v) { return _mm256_set1_ps(v); }
VERISIM_INLINE Register load(const float* p) { return _mm256_load_ps(p); }
VERISIM_INLINE Register load(const std::uint16_t* p) {
  return _mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(p))));
}
VERISIM_INLINE void store(float* p, Register v) { _mm256_store_ps(p, v); }
VERISIM_INLINE Register smaller(Register a, Register b) { return _mm256_min_ps(a, b); }
VERISIM_INLINE Register larger(Register a, Register b) { return _mm256_max_ps(a, b); }
VERISIM_INLINE unsigned at_most(Register a, Register b) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OS)));
}
#include "tracer/shapes/heights/height_walk.inc"
#include "tracer/shapes/heights/height_packet.inc"
}  // namespace avx2
#undef VERISIM_INSTRUCTION_SET
#pragma GCC target("avx2,bmi,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
#define VERISIM_INSTRUCTION_SET 2
namespace avx512 {
using Register = __m512;
VERISIM_INLINE Register broadcast(float v) { return _mm512_set1_ps(v); }
VERISIM_INLINE Register load(const float* p) { return _mm512_load_ps(p); }
VERISIM_INLINE Register load(const std::uint16_t* p) {
  return _mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(p))));
}
VERISIM_INLINE void store(float* p, Register v) { _mm512_store_ps(p, v); }
VERISIM_INLINE Register smaller(Register a, Register b) { return _mm512_min_ps(a, b); }
VERISIM_INLINE Register larger(Register a, Register b) { return _mm512_max_ps(a, b); }
VERISIM_INLINE unsigned at_most(Register a, Register b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OS); }
#include "tracer/shapes/heights/height_walk.inc"
#include "tracer/shapes/heights/height_packet.inc"
}  // namespace avx512
#undef VERISIM_INSTRUCTION_SET
#pragma GCC pop_options

constexpr auto kNext = std::to_array({&baseline::next, &avx2::next, &avx512::next});
constexpr const HeightPacketKernels* kPacketKernels[] = {&baseline::kPacketKernels, &avx2::kPacketKernels,
                                                         &avx512::kPacketKernels};
#else
constexpr decltype(&baseline::next) kNext[simd::kInstructionSets] = {&baseline::next, &baseline::next, &baseline::next};
constexpr const HeightPacketKernels* kPacketKernels[simd::kInstructionSets] = {
    &baseline::kPacketKernels, &baseline::kPacketKernels, &baseline::kPacketKernels};
#endif

// The smallest block that holds the cells of the ray between `enter` and `leave`.
HeightWalk::Block smallest_block(const HeightGrid& grid, const Vec3& o, const Vec3& d, double enter, double leave,
                                 double margin) {
  const auto first_and_last = [&](double from, double along, int cells) {
    const double a = from + enter * along, b = from + leave * along;
    const auto cell = [&](double at) { return static_cast<unsigned>(at > 0 ? std::min(at, cells - 1.0) : 0); };
    return std::pair(cell(std::min(a, b) - margin), cell(std::max(a, b) + margin));
  };
  const auto [i0, i1] = first_and_last(o.x, d.x, grid.width() - 1);
  const auto [k0, k1] = first_and_last(o.z, d.z, grid.depth() - 1);
  const int level = std::max(1, static_cast<int>(std::bit_width((i0 ^ i1) | (k0 ^ k1)) + 1) / 2);
  return {level, static_cast<int>(i0 >> 2 * level), static_cast<int>(k0 >> 2 * level), -HUGE_VALF};
}

const auto next_of_best = kNext[simd::best_instruction_set()];

}  // namespace

HeightWalk::HeightWalk(const HeightGrid& grid, const Vec3& o, const Vec3& d, double enter, double leave) {
  State& s = state_;
  s.grid = &grid, s.origin = o;
  s.enter = static_cast<float>(enter - std::fabs(enter) * 1e-6);
  const auto reciprocal = [](double v) {
    return static_cast<float>(std::clamp(1 / (v == 0 ? 1e-30 : v), -1e30, 1e30));
  };
  s.inverse_x = reciprocal(d.x), s.inverse_z = reciprocal(d.z);
  for (int c = 0; c < HeightGrid::kChildren; ++c) {
    s.x_steps[c] = static_cast<float>(HeightGrid::column(c)) * s.inverse_x;
    s.z_steps[c] = static_cast<float>(HeightGrid::row(c)) * s.inverse_z;
  }
  s.backward_x = d.x < 0, s.backward_z = d.z < 0;
  s.flip = (s.backward_x ? 5u : 0u) | (s.backward_z ? 10u : 0u);
  s.height = static_cast<float>(o.y), s.slope = static_cast<float>(d.y);
  // Triangles are accepted slightly beyond their edges, and their planes reach beyond the heights at the corners by as
  // much.
  s.side_margin = static_cast<float>(1e-3 + 1e-6 * (std::fabs(o.x) + std::fabs(o.z) + grid.width() + grid.depth()));
  s.height_margin = static_cast<float>(1 + 1e-6 * (65536 + 2 * std::fabs(o.y)));
  s.waiting = 1;
  s.blocks[0] = smallest_block(grid, o, d, enter, leave, s.side_margin);
}

int HeightWalk::next(float end, HeightCell cells[kCells]) { return next_of_best(state_, end, cells); }

int HeightWalk::next(int set, float end, HeightCell cells[kCells]) {
  return set <= simd::best_instruction_set() ? kNext[static_cast<std::size_t>(set)](state_, end, cells) : -1;
}

const HeightPacketKernels* height_packet_kernels(int set) {
  return set <= simd::best_instruction_set() ? kPacketKernels[set] : nullptr;
}

const HeightPacketKernels& height_packet_kernels() {
  static const HeightPacketKernels& best = *kPacketKernels[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
