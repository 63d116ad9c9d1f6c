// Any program gives the same bits three ways: interpreted, as native code, and for many points at once.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "tracer/functions/program.h"
#include "tracer/functions/program_packet.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::functions {
namespace {

constexpr int kParameters = 3;
constexpr std::size_t kProgramWidth = ProgramKernels::kNarrow;

// Draws expressions of a few dozen nodes from everything that functions are made of, but loops.
class Inventor {
 public:
  explicit Inventor(unsigned seed) : random_(seed) {}

  Node expression(int depth) {
    if (depth == 0 || one_in(8)) return leaf();
    switch (below(8)) {
      case 0:
        return {Negate{{expression(depth - 1)}}};
      case 1:
      case 2:
        return builtin(depth);
      case 3:
        return select(depth);
      case 4:
        return one_in(3) ? call(depth) : chain(depth);
      default:
        return chain(depth);
    }
  }
  // Round numbers, any size, and what is no number.
  double value() {
    constexpr double kSpecial[] = {0, -0.0, 1, -1, INFINITY, -INFINITY, NAN, 5e-324, 1e308, -2147483649.0};
    if (one_in(6)) return kSpecial[below(10)];
    if (one_in(3)) return below(21) - 10;
    return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random_), below(12) - 4);
  }

 private:
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  bool one_in(int n) { return below(n) == 0; }
  std::vector<Node> expressions(int count, int depth) {
    std::vector<Node> all;
    for (int k = 0; k < count; ++k) all.push_back(expression(depth));
    return all;
  }
  Node leaf() {
    if (one_in(3)) return {Constant{below(21) / 4.0 - 2}};
    return {Parameter{below(kParameters)}};
  }
  Node chain(int depth) {
    Chain made{{expression(depth - 1)}, {}};
    const int kind = below(4);  // operators of one precedence
    const int first[] = {0, 2, 4, 10}, count[] = {2, 2, 6, 2};
    for (int k = below(3); k >= 0; --k) {
      made.operators.push_back(static_cast<Op>(first[kind] + below(count[kind])));
      made.operands.push_back(expression(depth - 1));
    }
    return {made, one_in(2)};
  }
  Node builtin(int depth) {
    const auto function = static_cast<Builtin>(below(static_cast<int>(Builtin::tanh_) + 1));
    switch (function) {
      case Builtin::select_:
        return select(depth);
      case Builtin::atan2_:
      case Builtin::div_:
      case Builtin::mod_:
      case Builtin::pow_:
        return {BuiltinCall{function, expressions(2, depth - 1)}};
      case Builtin::max_:
      case Builtin::min_:
        return {BuiltinCall{function, expressions(2 + below(2), depth - 1)}};
      default:
        return {BuiltinCall{function, expressions(1, depth - 1)}};
    }
  }
  // Cheap branches are evaluated both, costly ones are jumped over.
  Node select(int depth) { return {BuiltinCall{Builtin::select_, expressions(3 + below(2), depth - 1)}}; }
  Node call(int depth) {
    static const FunctionPtr sphere = internal_function(61, 2), noise = internal_function(75, 2);
    const FunctionPtr& f = one_in(2) ? sphere : noise;
    return {UserCall{f, expressions(f->parameters(), depth - 1)}};
  }

  std::mt19937 random_;
};

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

// Null: refused, as a division by a literal 0 is.
std::shared_ptr<const Program> compiled(const Node& node) {
  try {
    return std::dynamic_pointer_cast<const Program>(compile(node, kParameters, kParameters));
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

// The values of `points` (three columns of kProgramWidth) by one instruction set's kernels.
std::vector<double> in_packet(const Program& program, const ProgramKernels& kernels,
                              const std::vector<double>& points) {
  struct alignas(64) Row {
    double values[kProgramWidth];
  };
  std::vector<Row> rows(program.registers());
  double* const registers = rows[0].values;
  program.set_constants(registers, kProgramWidth);
  std::copy(points.begin(), points.end(), registers);
  kernels.narrow(program.code(), program.calls(), registers, 255);
  const Row& result = rows[program.result_register()];
  return {result.values, result.values + kProgramWidth};
}

TEST(RandomPrograms, GiveTheSameBitsInterpretedNativeAndInPackets) {
  int programs = 0, with_jumps = 0, with_calls = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Inventor inventor(seed);
    const auto program = compiled(inventor.expression(2 + seed % 5));
    if (!program) continue;
    ++programs, with_jumps += program->has_jumps(), with_calls += !program->calls().empty();
#if defined(__x86_64__) && defined(__linux__)
    ASSERT_TRUE(program->is_native());
#endif
    std::vector<double> points(kParameters * kProgramWidth), expected;
    for (double& v : points) v = inventor.value();
    for (std::size_t k = 0; k < kProgramWidth; ++k) {
      const double point[] = {points[k], points[kProgramWidth + k], points[2 * kProgramWidth + k]};
      expected.push_back(program->interpret(point));
      double native;
      program->evaluate(point, &native);
      ASSERT_TRUE(same(native, expected[k])) << "seed " << seed << ": native " << native << " != " << expected[k];
    }
    if (program->has_jumps()) continue;
    for (int set = 0; set < simd::kInstructionSets; ++set) {
      const ProgramKernels* const kernels = packet_kernels(set);
      if (!kernels) continue;
      const std::vector<double> found = in_packet(*program, *kernels, points);
      for (std::size_t k = 0; k < kProgramWidth; ++k)
        ASSERT_TRUE(same(found[k], expected[k]))
            << "seed " << seed << ", instruction set " << set << ": " << found[k] << " != " << expected[k];
    }
  }
  EXPECT_GT(programs, 2000);
  EXPECT_GT(with_jumps, 200);
  EXPECT_GT(with_calls, 200);
}

}  // namespace
}  // namespace verisim::functions
