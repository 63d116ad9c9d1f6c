#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/simd/packet_test.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim {
namespace {

using Check = void (*)();

namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNumbers[] = {0.0, -0.0, 1.5, -2.25, 1e300, 5e-324, 0x1.fffffefffffffp-1, kInfinity, -kInfinity, kNan};

struct Operands {
  alignas(64) double a[kLanes], b[kLanes];
};

std::uint64_t bits_at(const Packet& p, int k) { return std::bit_cast<std::uint64_t>(p[k]); }
bool same(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
}

void expect_plain_results(const Operands& o) {
  const Packet a = load(o.a), b = load(o.b);
  const Mask less = a < b, differ = a != b;
  const unsigned odd = 0xa5;
  for (int k = 0; k < kLanes; ++k) {
    const double x = o.a[k], y = o.b[k];
    // The very operand, zeros of either sign and NaN included.
    EXPECT_EQ(bits_at(min(a, b), k), std::bit_cast<std::uint64_t>(std::min(x, y))) << x << " " << y;
    EXPECT_EQ(bits_at(max(a, b), k), std::bit_cast<std::uint64_t>(std::max(x, y))) << x << " " << y;
    EXPECT_EQ(bits_at(abs(a), k), std::bit_cast<std::uint64_t>(std::fabs(x)));
    EXPECT_EQ(bits_at(-a, k), std::bit_cast<std::uint64_t>(-x));
    EXPECT_TRUE(same(sqrt(a)[k], std::sqrt(x)));
    EXPECT_TRUE(same((a + b)[k], x + y) && same((a - b)[k], x - y) && same((a * b)[k], x * y) &&
                same((a / b)[k], x / y));
    EXPECT_EQ(bits(less) >> k & 1, x < y ? 1u : 0u);
    EXPECT_EQ(bits(a <= b) >> k & 1, x <= y ? 1u : 0u);
    EXPECT_EQ(bits(a == b) >> k & 1, x == y ? 1u : 0u);
    EXPECT_EQ(bits(differ) >> k & 1, x != y ? 1u : 0u) << x << " " << y;
    EXPECT_EQ(bits_at(select(Mask::of_bits(odd), a, b), k), std::bit_cast<std::uint64_t>(odd >> k & 1 ? x : y));
    const FloatPacket rounded = to_floats(a);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(rounded[k]) & 0x7fc00000u,
              std::bit_cast<std::uint32_t>(static_cast<float>(x)) & 0x7fc00000u);
    EXPECT_TRUE(std::isnan(x) || rounded[k] == static_cast<float>(x));
    EXPECT_EQ(bits_of(a)[k], std::bit_cast<std::int64_t>(x));
    EXPECT_EQ(shift_right<52>(bits_of(a))[k], std::bit_cast<std::int64_t>(x) >> 52);
  }
}

void expect_plain_results() {
  for (const double x : kNumbers) {
    for (const double y : kNumbers) {
      Operands o;
      for (int k = 0; k < kLanes; ++k) o.a[k] = k % 2 ? x : kNumbers[k], o.b[k] = y;
      expect_plain_results(o);
    }
  }
}

void expect_masks_kept() {
  for (unsigned lanes = 0; lanes < 256; ++lanes) {
    const Mask mask = Mask::of_bits(lanes);
    EXPECT_EQ(bits(mask), lanes);
    EXPECT_EQ(bits(~mask), lanes ^ 255);
    EXPECT_EQ(bits(mask & Mask::all()), lanes);
    alignas(64) std::int64_t kept[kLanes];
    store_mask(kept, mask);
    for (int k = 0; k < kLanes; ++k) EXPECT_EQ(kept[k], lanes >> k & 1 ? -1 : 0);
    EXPECT_EQ(bits(load_mask(kept)), lanes);
  }
}

// {} sets everything to zero; NEON's vectors by themselves would keep what was there.
HWY_NOINLINE void fill_stack() {
  volatile unsigned char room[4096];
  for (volatile unsigned char& byte : room) byte = 0x5a;
}
struct Both {
  Mask mask;
  Packet numbers;
};
HWY_NOINLINE void store_empty_braces(bool other, std::int64_t* mask, double* numbers) {
  Both both{};
  if (other) both = {Mask::all(), Packet(1.0)};
  store_mask(mask, both.mask), store(numbers, both.numbers);
}
void expect_empty_braces_zero() {
  alignas(64) std::int64_t mask[kLanes];
  alignas(64) double numbers[kLanes];
  fill_stack();
  store_empty_braces(false, mask, numbers);
  for (int k = 0; k < kLanes; ++k) EXPECT_TRUE(mask[k] == 0 && numbers[k] == 0) << mask[k] << " " << numbers[k];
}

void check() {
  expect_empty_braces_zero();
  expect_plain_results();
  expect_masks_kept();
}
const Check kKernels = check;

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim {
namespace {

VERISIM_EXPORT_KERNELS(Check, check)

TEST(Packet, DoesWhatPlainNumbersDoWithEveryInstructionSet) {
  for (int set = 0; set <= simd::best_instruction_set(); ++set) {
    SCOPED_TRACE(set);
    (*check(set))();
  }
  EXPECT_EQ(&check(), check(simd::best_instruction_set()));
}

}  // namespace
}  // namespace verisim
#endif
