#include "tracer/functions/bounds/error_bound.h"

#include <random>

#include <gtest/gtest.h>

#include "tracer/functions/program_packet.h"
#include "tracer/functions/test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::functions {
namespace {

using namespace test;

Node waves() { return times(of(Builtin::sin_, {times(number(6), x())}), of(Builtin::cos_, {times(number(40), y())})); }
Node angle() { return of(Builtin::atan2_, {x(), z()}); }
Node distance_from_axis() { return of(Builtin::sqrt_, {plus(times(x(), x()), times(z(), z()))}); }

const Box3 kBox{Vec3(-1.5), Vec3(1)};
double error_bound_of(const FunctionPtr& f) { return error_bound(dynamic_cast<const Program&>(*f), kBox); }

TEST(ErrorBound, HoldsWhatNearValuesAreOffBy) {
  const std::vector<Node> expressions{waves(),
                                      plus(distance_from_axis(), times(number(0.1), waves())),
                                      plus(times(y(), y()), of(Builtin::cos_, {times(number(8), angle())})),
                                      chain(waves(), Op::divide, plus(number(3), waves())),
                                      of(Builtin::sqrt_, {plus(number(2), waves())}),
                                      of(Builtin::abs_, {chain(waves(), Op::subtract, x())}),
                                      of(Builtin::min_, {distance_from_axis(), of(Builtin::max_, {waves(), angle()})}),
                                      of(Builtin::select_, {x(), waves(), y(), angle()}),
                                      times(times(number(1000), waves()), waves()),
                                      of(Builtin::pow_, {distance_from_axis(), x()})};
  std::mt19937 random(21);
  std::uniform_real_distribution<double> unit(0, 1);
  double closest = 0;
  for (const Node& expression : expressions) {
    const FunctionPtr f = compile(expression, 3, 3);
    const auto& program = dynamic_cast<const Program&>(*f);
    const double most = error_bound_of(f);
    ASSERT_LT(most, 1e-8);
    for (int set = 0; set < simd::kInstructionSets; ++set) {
      const ProgramKernels* const kernels = packet_kernels(set);
      if (!kernels) continue;
      constexpr std::size_t kNarrow = ProgramKernels::kNarrow, kMax = 64;
      alignas(64) double exact[kMax * kNarrow] = {}, near[kMax * kNarrow] = {};
      ASSERT_LE(program.registers(), kMax);
      for (double* r : {exact, near}) program.set_constants(r, kNarrow);
      for (int n = 0; n < 2000; ++n) {
        for (std::size_t k = 0; k < 3 * kNarrow; ++k) exact[k] = near[k] = -1.5 + 2.5 * unit(random);
        kernels->narrow(program.code(), {}, exact, 255), kernels->approximate(program.code(), {}, near, 255);
        for (std::size_t k = 0; k < kNarrow; ++k) {
          const double a = exact[program.result_register() * kNarrow + k],
                       b = near[program.result_register() * kNarrow + k];
          ASSERT_TRUE(a == b || std::fabs(a - b) <= most || (std::isnan(a) && std::isnan(b)))
              << (&expression - expressions.data()) << ": " << a << ' ' << b;
          if (most > 0) closest = std::max(closest, std::fabs(a - b) / most);
        }
      }
    }
  }
  EXPECT_GT(closest, 0.02);
}

TEST(ErrorBound, IsUnknownWhereItIsMagnified) {
  for (const Node& f :
       {chain(number(1), Op::divide, waves()), of(Builtin::sqrt_, {waves()}), of(Builtin::floor_, {waves()}),
        of(Builtin::atan2_, {waves(), x()}), of(Builtin::select_, {waves(), x(), y(), z()}),
        of(Builtin::sin_, {times(number(1e6), x())}), of(Builtin::exp_, {waves()})})
    EXPECT_TRUE(std::isinf(error_bound_of(compile(f, 3, 3))));
}

}  // namespace
}  // namespace verisim::functions
