// Wall time, CPU time and peak memory of both programs as whole processes, run in turn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/oracle/switches.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace {

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  const std::size_t n = v.size();
  return n == 0 ? 0 : n % 2 ? v[n / 2] : 0.5 * (v[n / 2 - 1] + v[n / 2]);
}

// Of each figure on its own.
BenchSample median(const std::vector<BenchSample>& samples) {
  std::vector<double> wall, cpu, memory;
  for (const BenchSample& s : samples)
    wall.push_back(s.wall), cpu.push_back(s.cpu), memory.push_back(static_cast<double>(s.peak_bytes));
  return {median(wall), median(cpu), static_cast<std::uint64_t>(median(memory))};
}

double time_ratio(double oracle, double native) { return native > 0 ? oracle / native : 0; }

BenchSample run_native(const NativeRenderer& native, const SceneRequest& scene, const BenchOptions& options,
                       const std::vector<std::filesystem::path>& library_paths, std::string& error) {
  const WorkingCopy copy(scene.scene);
  NativeRequest request;
  request.folder = copy.folder(), request.scene = copy.scene(),
  request.output = copy.out() / ("picture" + output_extension(scene.switches));
  request.width = scene.width, request.height = scene.height, request.switches = scene.switches;
  request.threads = options.threads, request.time_limit = options.time_limit, request.library_paths = library_paths;
  if (!output_type(scene.switches)) request.switches.push_back("+FN8");
  const NativeResult result = native(request);
  if (result.outcome != NativeResult::Outcome::rendered) error = "verisim: " + result.message;
  return {result.seconds, result.cpu_seconds, result.peak_bytes};
}

BenchScene bench_scene(const SceneRequest& scene, const BenchOptions& options, const OracleProgram& program,
                       const OracleOptions& oracle_options, const NativeRenderer& native) {
  BenchScene out;
  out.name = scene.name;
  for (int run = 0; run < options.runs && out.error.empty(); ++run) {
    if (options.progress) options.progress(scene.name, run);
    const OracleRender oracle = run_oracle(program, oracle_options, scene, 0, {});
    if (!oracle.ok) {
      out.error = oracle.message;
      break;
    }
    out.oracle.push_back({oracle.seconds, oracle.cpu_seconds, oracle.peak_bytes});
    out.native.push_back(run_native(native, scene, options, program.library_paths, out.error));
  }
  if (!out.error.empty()) return out;
  out.oracle_median = median(out.oracle), out.native_median = median(out.native);
  out.wall_ratio = time_ratio(out.oracle_median.wall, out.native_median.wall);
  out.cpu_ratio = time_ratio(out.oracle_median.cpu, out.native_median.cpu);
  out.memory_ratio =
      time_ratio(static_cast<double>(out.oracle_median.peak_bytes), static_cast<double>(out.native_median.peak_bytes));
  return out;
}

double geometric_mean(const std::vector<BenchScene>& scenes, double BenchScene::*figure) {
  double sum = 0;
  int count = 0;
  for (const BenchScene& s : scenes)
    if (s.error.empty() && s.*figure > 0) sum += std::log(s.*figure), ++count;
  return count ? std::exp(sum / count) : 0;
}

}  // namespace

Bench run_bench(const Suite& suite, const BenchOptions& options) {
  const OracleProgram program = find_oracle(options.oracle);
  OracleOptions oracle_options = options.oracle;
  oracle_options.use_cache = false;
  oracle_options.threads = options.threads, oracle_options.time_limit = options.time_limit;
  const NativeRenderer native = native_program(options.native_program);
  Bench out;
  out.oracle_version = program.version;
  for (const SceneRequest& scene : suite.scenes) {
    try {
      out.scenes.push_back(bench_scene(scene, options, program, oracle_options, native));
    } catch (const std::exception& error) {
      out.scenes.emplace_back().name = scene.name;
      out.scenes.back().error = error.what();
    }
  }
  out.wall_ratio = geometric_mean(out.scenes, &BenchScene::wall_ratio);
  out.cpu_ratio = geometric_mean(out.scenes, &BenchScene::cpu_ratio);
  out.memory_ratio = geometric_mean(out.scenes, &BenchScene::memory_ratio);
  return out;
}

std::string bench_table(const Bench& bench, bool color) {
  const char *bold = color ? "\033[1m" : "", *red = color ? "\033[31m" : "", *reset = color ? "\033[0m" : "";
  std::string out =
      fmt::format("{}{:<40} {:>9} {:>9} {:>7} {:>9} {:>9} {:>7} {:>8} {:>8} {:>7}{}\n", bold, "scene", "POV CPU",
                  "ours CPU", "ratio", "POV wall", "ours wall", "ratio", "POV MiB", "ours MiB", "ratio", reset);
  constexpr double kMiB = 1 << 20;
  for (const BenchScene& s : bench.scenes) {
    std::string name = s.name;
    if (name.size() > 40) name = "..." + name.substr(name.size() - 37);
    if (!s.error.empty()) {
      out += fmt::format("{:<40} {}{}{}\n", name, red, s.error, reset);
      continue;
    }
    const BenchSample &o = s.oracle_median, &n = s.native_median;
    out +=
        fmt::format("{:<40} {:>8.3f}s {:>8.3f}s {:>6.2f}x {:>8.3f}s {:>8.3f}s {:>6.2f}x {:>8.1f} {:>8.1f} {:>6.2f}x\n",
                    name, o.cpu, n.cpu, s.cpu_ratio, o.wall, n.wall, s.wall_ratio,
                    static_cast<double>(o.peak_bytes) / kMiB, static_cast<double>(n.peak_bytes) / kMiB, s.memory_ratio);
  }
  return out + fmt::format("{}{:<40} {:>9} {:>9} {:>6.2f}x {:>9} {:>9} {:>6.2f}x {:>8} {:>8} {:>6.2f}x{}\n", bold,
                           "geometric mean", "", "", bench.cpu_ratio, "", "", bench.wall_ratio, "", "",
                           bench.memory_ratio, reset);
}

std::string bench_json(const Bench& bench) {
  using Json = nlohmann::ordered_json;
  const auto sample = [](const BenchSample& s) {
    return Json{{"wall", s.wall}, {"cpu", s.cpu}, {"peak_bytes", s.peak_bytes}};
  };
  const auto ratios = [](const auto& b) {
    return Json{{"cpu", b.cpu_ratio}, {"wall", b.wall_ratio}, {"memory", b.memory_ratio}};
  };
  Json json;
  json["scenes"] = Json::array();
  for (const BenchScene& s : bench.scenes) {
    Json scene;
    scene["scene"] = s.name;
    if (!s.error.empty()) {
      scene["error"] = s.error;
    } else {
      scene["oracle"] = sample(s.oracle_median), scene["native"] = sample(s.native_median), scene["ratio"] = ratios(s);
      for (const BenchSample& r : s.oracle) scene["runs"]["oracle"].push_back(sample(r));
      for (const BenchSample& r : s.native) scene["runs"]["native"].push_back(sample(r));
    }
    json["scenes"].push_back(scene);
  }
  json["geometric_mean"] = ratios(bench);
  json["oracle_version"] = bench.oracle_version;
  return json_text(json, 2) + "\n";
}

}  // namespace verisim::compare
