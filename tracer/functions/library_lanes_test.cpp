// Lanes of the C library's functions have its bits, on every instruction set.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/functions/library_lanes_test.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/functions/library_lanes-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::functions::library_lanes_test {
namespace {

using Calls = void (*)(LibraryFunction f, const double* a, const double* b, unsigned asked, double* results);

namespace HWY_NAMESPACE {

using namespace functions::HWY_NAMESPACE;

constexpr int kWidth = 16;

void call(LibraryFunction f, const double* a, const double* b, unsigned asked, double* results) {
  using Value = PacketOf<kWidth>;
  const LibraryLanes<kWidth> library{asked};
  const auto of = [&](const Value& x) HWY_ATTR {
    switch (f) {
      case LibraryFunction::sin:
        return library.sine_and_cosine(x).sine;
      case LibraryFunction::cos:
        return library.sine_and_cosine(x).cosine;
      case LibraryFunction::atan:
        return library.atan(x);
      case LibraryFunction::atan2:
        return library.atan2(x, Value::load(b));
      case LibraryFunction::log:
        return library.log(x);
      case LibraryFunction::exp:
        return library.exp(x);
      case LibraryFunction::sinh:
        return library.sinh(x);
      default:
        return library.cosh(x);
    }
  };
  store(results, of(Value::load(a)));
}

constexpr Calls kKernels = call;

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions::library_lanes_test
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::functions::library_lanes_test {
VERISIM_EXPORT_KERNELS(Calls, calls)

namespace {

using HWY_NAMESPACE::kWidth;

double plain(LibraryFunction f, double a, double b) {
  const PlainLibrary library;
  switch (f) {
    case LibraryFunction::sin:
      return std::sin(a);
    case LibraryFunction::cos:
      return std::cos(a);
    case LibraryFunction::atan:
      return library.atan(a);
    case LibraryFunction::atan2:
      return library.atan2(a, b);
    case LibraryFunction::log:
      return library.log(a);
    case LibraryFunction::exp:
      return library.exp(a);
    case LibraryFunction::sinh:
      return library.sinh(a);
    default:
      return library.cosh(a);
  }
}

// What is not a number, zeros, the smallest and the largest, where functions change their ways, and many sizes.
std::vector<double> arguments(std::mt19937_64& random) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> all;
  const auto add = [&](double v) { all.push_back(v), all.push_back(-v); };
  for (const double v : {0.0, kInfinity, std::nan(""), 5e-324, 1e-310, 0x1p-1022, 1e-300, 0x1p-54, 0x1p-28, 1e300,
                         1.7e308, 700.0, 709.5, 710.2, 745.0, 1e22})
    add(v);
  for (const double edge : {std::log(2.0) / 2, 1.5 * std::log(2.0), 1.0, 22.0, 0x1.62e43p-2, 0x1.0a2b2p0})
    for (int n = -20; n <= 20; ++n) add(edge * (1 + n * 0x1p-52)), add(edge * (1 + n * 0x1p-22));
  // Halves between multiples of ln 2, where sums that are rounded choose the multiple.
  for (int n = 0; n < 40; ++n)
    for (int k = -20; k <= 20; ++k) add((n + 0.5) * std::log(2.0) * (1 + k * 0x1p-52));
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double size : {1e-9, 1e-3, 0.1, 0.34, 1.0, 1.1, 3.0, 10.0, 22.5, 720.0, 1e5})
    for (int n = 0; n < 20000; ++n) all.push_back(size * unit(random));
  for (int n = 0; n < 20000; ++n) add(std::exp2(1060 * unit(random)));
  all.resize(all.size() / kWidth * kWidth);
  return all;
}

bool same(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
}

TEST(LibraryLanes, HaveTheBitsOfTheLibrary) {
  std::mt19937_64 random(5);
  const std::vector<double> a = arguments(random);
  std::vector<double> b = a;
  std::shuffle(b.begin(), b.end(), random);
  for (std::size_t k = 0; k < b.size(); k += 5) b[k] = k % 2 == 0 ? 0.0 : -0.0;
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const Calls* const call = calls(set);
    if (!call) continue;
    for (int f = 0; f <= static_cast<int>(LibraryFunction::cosh); ++f) {
      const auto function = static_cast<LibraryFunction>(f);
      for (std::size_t begin = 0; begin < a.size(); begin += kWidth) {
        const unsigned asked = begin % 3 == 0 ? 0xffffu : static_cast<unsigned>(random()) & 0xffffu;
        for (const bool swapped : {false, true}) {
          const double *x = &a[begin], *y = &b[begin];
          if (swapped) std::swap(x, y);
          double results[kWidth];
          (*call)(function, x, y, asked, results);
          for (int k = 0; k < kWidth; ++k) {
            if ((asked >> k & 1) == 0) continue;
            const double expected = plain(function, x[k], y[k]);
            ASSERT_TRUE(same(results[k], expected)) << "set " << set << ", function " << f << " of " << x[k] << ", "
                                                    << y[k] << ": " << results[k] << " != " << expected;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace verisim::functions::library_lanes_test
#endif
