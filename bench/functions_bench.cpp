// Calls per second of user functions: one point (native code where there is some) and batches.
#include <benchmark/benchmark.h>

#include "tracer/functions/expression.h"

namespace verisim::functions {
namespace {

Node number(double v) { return {Constant{v}}; }
Node parameter(int i) { return {Parameter{i}}; }
Node chain(std::vector<Node> operands, std::vector<Op> operators) {
  return {Chain{std::move(operands), std::move(operators)}};
}
Node square(int i) { return chain({parameter(i), parameter(i)}, {Op::multiply}); }

// x*x + y*y + z*z - 1
Node sphere() { return chain({square(0), square(1), square(2), number(1)}, {Op::add, Op::add, Op::subtract}); }
// About twenty operations.
Node longer() {
  const Node cubic =
      chain({parameter(0), parameter(1), parameter(2), number(.5)}, {Op::multiply, Op::multiply, Op::multiply});
  const Node product = chain({sphere(), parameter(0), number(3)}, {Op::multiply, Op::multiply});
  const Node quartic = chain({square(1), square(1), number(.1)}, {Op::multiply, Op::multiply});
  return chain({sphere(), product, cubic, chain({parameter(0), number(2)}, {Op::multiply}), quartic},
               {Op::add, Op::subtract, Op::add, Op::subtract});
}

void one_point(benchmark::State& state, const Node& expression) {
  const FunctionPtr f = compile(expression, 3, 3);
  double p[3] = {.1, .2, .3}, result;
  for (auto _ : state) {
    p[0] += 1e-9;
    f->evaluate(p, &result);
    benchmark::DoNotOptimize(result);
  }
  state.SetItemsProcessed(state.iterations());
}
void batch(benchmark::State& state, const Node& expression) {
  const FunctionPtr f = compile(expression, 3, 3);
  const auto n = static_cast<std::size_t>(state.range(0));
  std::vector<double> p(3 * n, .3), result(n);
  for (auto _ : state) {
    f->evaluate_batch(p.data(), n, n, result.data());
    benchmark::DoNotOptimize(result.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK_CAPTURE(one_point, sphere, sphere());
BENCHMARK_CAPTURE(one_point, twenty_operations, longer());
BENCHMARK_CAPTURE(batch, sphere, sphere())->Arg(8)->Arg(64);
BENCHMARK_CAPTURE(batch, twenty_operations, longer())->Arg(8)->Arg(64);

}  // namespace
}  // namespace verisim::functions
