// Nanoseconds per evaluation of noise and of the patterns that are made of it.
//
// Beside POV-Ray: bench/textures, by differences of whole pictures; tools/measure_noise/speed.sh, which times `function
// { pattern { ... } }` in an SDL loop minus the cheapest pattern.
#include <benchmark/benchmark.h>

#include <vector>

#include "tracer/noise/noise.h"
#include "tracer/textures/texture.h"

namespace {

using namespace verisim;
using namespace verisim::textures;

// The points that the pixels of a picture see on a tilted plane, row by row: 8 x 6 units at 640 x 480.
std::vector<Vec3> make_points() {
  std::vector<Vec3> result;
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) {
      const double u = (x + 0.5) / 80 - 4, v = 3 - (y + 0.5) / 80;
      result.emplace_back(u, 0.8 * v, 0.6 * v + 0.3);
    }
  return result;
}
const std::vector<Vec3>& points() {
  static const std::vector<Vec3> all = make_points();
  return all;
}

template <class F>
void run(benchmark::State& state, F f) {
  const auto& all = points();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(f(all[i]));
    if (++i == all.size()) i = 0;
  }
  state.SetItemsProcessed(state.iterations());
}

void noise_generator(benchmark::State& state) {
  run(state, [g = static_cast<int>(state.range(0))](const Vec3& p) { return noise(p, g); });
}
BENCHMARK(noise_generator)->Arg(1)->Arg(2)->Arg(3);

void noise_reference(benchmark::State& state) {
  run(state, [g = static_cast<int>(state.range(0))](const Vec3& p) { return reference::noise(p, g); });
}
BENCHMARK(noise_reference)->Arg(2)->Arg(3);

void vector_noise_three_components(benchmark::State& state) {
  run(state, [](const Vec3& p) { return vector_noise(p); });
}
BENCHMARK(vector_noise_three_components);

void turbulence_six_octaves(benchmark::State& state) {
  run(state, [](const Vec3& p) { return turbulence(p, 6, 2, 0.5, 2); });
}
BENCHMARK(turbulence_six_octaves);

void vector_turbulence_six_octaves(benchmark::State& state) {
  run(state, [](const Vec3& p) { return vector_turbulence(p, 6, 2, 0.5); });
}
BENCHMARK(vector_turbulence_six_octaves);

void pattern(benchmark::State& state, scene::PatternKind kind) {
  scene::Pattern description;
  description.kind = kind;
  if (kind == scene::PatternKind::agate) description.params = scene::AgateParams{};
  Compiler compiler{Settings{}};
  const CompiledPattern* compiled = compiler.pattern(description);
  run(state, [compiled](const Vec3& p) { return evaluate(*compiled, p, nullptr); });
}
BENCHMARK_CAPTURE(pattern, agate, scene::PatternKind::agate);
BENCHMARK_CAPTURE(pattern, bozo, scene::PatternKind::bozo);
BENCHMARK_CAPTURE(pattern, crackle, scene::PatternKind::crackle);
BENCHMARK_CAPTURE(pattern, granite, scene::PatternKind::granite);
BENCHMARK_CAPTURE(pattern, wrinkles, scene::PatternKind::wrinkles);
BENCHMARK_CAPTURE(pattern, wood, scene::PatternKind::wood);
BENCHMARK_CAPTURE(pattern, waves, scene::PatternKind::waves);

}  // namespace
