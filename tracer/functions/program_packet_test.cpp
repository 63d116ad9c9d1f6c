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

// Powers as shapes and functions ask for them: of many sizes, and near 1.
TEST(ProgramPacket, PowersHaveTheBitsOfTheLibrary) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  const Instruction instruction{Code::pow, 1, 0, 1, 0, 0};
  alignas(64) double registers[3 * kWidth];
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const ProgramKernels* const kernels = packet_kernels(set);
    if (!kernels) continue;
    for (int n = 0; n < 100000; ++n) {
      const double most = std::exp2(8 * unit(random) - 2);
      double x[kWidth], y[kWidth];
      for (std::size_t k = 0; k < kWidth; ++k) {
        y[k] = most * (unit(random) - 0.25);
        x[k] = n % 3 == 0   ? unit(random)
               : n % 3 == 1 ? 1 + unit(random) * std::exp2(-50 * unit(random))
                            : std::exp(60 * unit(random) - 30);
      }
      std::copy_n(x, kWidth, registers), std::copy_n(y, kWidth, registers + kWidth);
      kernels->narrow({&instruction, 1}, {}, registers, 255);
      for (std::size_t k = 0; k < kWidth; ++k)
        ASSERT_EQ(registers[kWidth + k], std::pow(x[k], y[k])) << "set " << set << ": " << x[k] << ", " << y[k];
    }
  }
}

TEST(ProgramPacket, OperationsGiveTheSameBitsInPacket) {
  std::mt19937_64 random(9);
  std::vector<double> a = arguments(random), b = arguments(random);
  std::shuffle(b.begin(), b.end(), random);
  for (std::size_t k = 0; k < a.size(); k += 3) b[k] = a[k];
  alignas(64) double registers[3 * kWidth];
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const ProgramKernels* const kernels = packet_kernels(set);
    if (!kernels) continue;
    for (int code = 0; code <= static_cast<int>(Code::move); ++code) {
      // The result replaces the second operand, as registers are used again.
      const Instruction instruction{static_cast<Code>(code), 1, 0, 1, 0, 0};
      for (std::size_t begin = 0; begin + kWidth <= a.size(); begin += kWidth) {
        std::copy_n(&a[begin], kWidth, registers);
        std::copy_n(&b[begin], kWidth, registers + kWidth);
        kernels->narrow({&instruction, 1}, {}, registers, 255);
        for (std::size_t k = 0; k < kWidth; ++k) {
          const double x = a[begin + k], y = b[begin + k], got = registers[kWidth + k];
          const double expected = with_code(instruction.code, [&]<Code C>() { return apply<C>(x, y); });
          ASSERT_TRUE(std::bit_cast<std::uint64_t>(got) == std::bit_cast<std::uint64_t>(expected) ||
                      (std::isnan(got) && std::isnan(expected)))
              << "code " << code << ", set " << set << ": " << x << ", " << y << ": " << got << " != " << expected;
        }
      }
    }
  }
}

TEST(ProgramPacket, ApproximateValuesAreWithinTheirError) {
  std::mt19937_64 random(10);
  std::vector<double> a = arguments(random);
  std::erase_if(a, [](double v) { return !(std::fabs(v) <= ProgramKernels::kMaxApproximate); });
  ASSERT_GT(a.size(), 10000u);
  std::vector<double> b = a;
  std::shuffle(b.begin(), b.end(), random);
  alignas(64) double registers[2 * kWidth];
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const ProgramKernels* const kernels = packet_kernels(set);
    if (!kernels) continue;
    for (const Code code : {Code::sin, Code::cos, Code::atan2}) {
      const Instruction instruction{code, 1, 0, 1};
      for (std::size_t begin = 0; begin + kWidth <= a.size(); begin += kWidth) {
        std::copy_n(&a[begin], kWidth, registers);
        std::copy_n(&b[begin], kWidth, registers + kWidth);
        kernels->approximate({&instruction, 1}, {}, registers, 255);
        for (std::size_t k = 0; k < kWidth; ++k) {
          const double expected = with_code(code, [&]<Code C>() { return apply<C>(a[begin + k], b[begin + k]); });
          ASSERT_LE(std::fabs(registers[kWidth + k] - expected), ProgramKernels::kApproximateError)
              << a[begin + k] << ", set " << set;
        }
      }
    }
  }
}

}  // namespace
}  // namespace verisim::functions
