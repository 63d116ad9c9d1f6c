// Every operation on lanes gives the bits that it gives for one number, on every instruction set.
#include "tracer/functions/program_packet.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "tracer/functions/operations.h"
#include "tracer/functions/sine_kernels.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::functions {
namespace {

constexpr std::size_t kWidth = ProgramKernels::kNarrow;

// What the library's functions are asked for: all sizes, near multiples of pi / 2, and what is not a number.
std::vector<double> arguments(std::mt19937_64& random) {
  constexpr double kPi = 3.14159265358979323846, kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> all{0.0,    -0.0,    1,      -1,    0.5,      -0.5,   kInfinity, -kInfinity, std::nan(""),
                          5e-324, -1e-310, 1e-300, 1e300, -1.7e308, 0x1p17, 0x1p20,    1e22};
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double size : {1e-9, 1e-3, 0.1, 1.0, 3.0, 10.0, 1e3, 1e5, 1e6})
    for (int n = 0; n < 4000; ++n) all.push_back(size * unit(random));
  for (int n = -200; n <= 200; ++n)
    for (const double off : {0.0, 1e-9, -1e-5}) all.push_back(n * kPi / 16 + off);
  for (int n = -200; n <= 200; ++n) all.push_back(n / 64.0);
  for (int n = 0; n < 4000; ++n) all.push_back(1 + 0.01 * unit(random));
  for (int n = 0; n < 4000; ++n) all.push_back(std::exp2(1000 * unit(random)));
  return all;
}

TEST(SineKernels, HaveTheBitsOfTheLibrary) {
  std::mt19937_64 random(5);
  const std::vector<double> angles = arguments(random);
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const SineKernels* const kernels = sine_kernels(set);
    if (!kernels) continue;
    for (const std::size_t count : {angles.size(), std::size_t{1}, std::size_t{13}}) {
      std::vector<double> sines(count), cosines(count);
      kernels->sines_and_cosines(angles.data(), static_cast<int>(count), sines.data(), cosines.data());
      for (std::size_t k = 0; k < count; ++k) {
        const double sine = std::sin(angles[k]), cosine = std::cos(angles[k]);
        ASSERT_TRUE(std::bit_cast<std::uint64_t>(sines[k]) == std::bit_cast<std::uint64_t>(sine) || std::isnan(sine));
        ASSERT_TRUE(std::bit_cast<std::uint64_t>(cosines[k]) == std::bit_cast<std::uint64_t>(cosine) ||
                    std::isnan(cosine));
      }
    }
  }
}

// Tells `check` what the kernels of each instruction set make of a[k] and b[k].
template <class Check>
void for_each_result(Code code, const std::vector<double>& a, const std::vector<double>& b,
                     decltype(ProgramKernels::narrow) ProgramKernels::*kernel, Check&& check) {
  // The result replaces the second operand, as registers are used again.
  const Instruction instruction{code, 1, 0, 1, 0, 0};
  alignas(64) double registers[3 * kWidth];
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const ProgramKernels* const kernels = packet_kernels(set);
    if (!kernels) continue;
    for (std::size_t begin = 0; begin + kWidth <= a.size(); begin += kWidth) {
      std::copy_n(&a[begin], kWidth, registers), std::copy_n(&b[begin], kWidth, registers + kWidth);
      (kernels->*kernel)({&instruction, 1}, {}, registers, 255);
      for (std::size_t k = 0; k < kWidth; ++k)
        ASSERT_NO_FATAL_FAILURE(check(a[begin + k], b[begin + k], registers[kWidth + k])) << "set " << set;
    }
  }
}
void expect_the_same_bits(Code code, const std::vector<double>& a, const std::vector<double>& b) {
  for_each_result(code, a, b, &ProgramKernels::narrow, [code](double x, double y, double got) {
    const double expected = with_code(code, [&]<Code C>() { return apply<C>(x, y); });
    ASSERT_TRUE(std::bit_cast<std::uint64_t>(got) == std::bit_cast<std::uint64_t>(expected) ||
                (std::isnan(got) && std::isnan(expected)))
        << "code " << static_cast<int>(code) << ": " << x << ", " << y << ": " << got << " != " << expected;
  });
}

// Powers as shapes and functions ask for them: of many sizes, and near 1.
TEST(ProgramPacket, PowersHaveTheBitsOfTheLibrary) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> x, y;
  for (int n = 0; n < 800000; ++n) {
    y.push_back(std::exp2(8 * unit(random) - 2) * (unit(random) - 0.25));
    x.push_back(n % 3 == 0   ? unit(random)
                : n % 3 == 1 ? 1 + unit(random) * std::exp2(-50 * unit(random))
                             : std::exp(60 * unit(random) - 30));
  }
  expect_the_same_bits(Code::pow, x, y);
}

TEST(ProgramPacket, OperationsGiveTheSameBitsInPacket) {
  std::mt19937_64 random(9);
  std::vector<double> a = arguments(random), b = arguments(random);
  std::shuffle(b.begin(), b.end(), random);
  for (std::size_t k = 0; k < a.size(); k += 3) b[k] = a[k];
  for (int code = 0; code <= static_cast<int>(Code::move); ++code) expect_the_same_bits(static_cast<Code>(code), a, b);
}

TEST(ProgramPacket, ApproximateValuesAreWithinTheirError) {
  std::mt19937_64 random(10);
  std::vector<double> a = arguments(random);
  std::erase_if(a, [](double v) { return !(std::fabs(v) <= ProgramKernels::kMaxApproximate); });
  ASSERT_GT(a.size(), 10000u);
  std::vector<double> b = a;
  std::shuffle(b.begin(), b.end(), random);
  for (const Code code : {Code::sin, Code::cos, Code::atan2})
    for_each_result(code, a, b, &ProgramKernels::approximate, [code](double x, double y, double got) {
      const double expected = with_code(code, [&]<Code C>() { return apply<C>(x, y); });
      ASSERT_LE(std::fabs(got - expected), ProgramKernels::kApproximateError) << x;
    });
}

}  // namespace
}  // namespace verisim::functions
