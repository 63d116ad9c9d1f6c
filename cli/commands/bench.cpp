// `verisim bench`: time and memory of verisim and POV-Ray as whole processes, run in turn.
#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/settings/reading/own_options.h"
#include "cli/commands/own_program.h"

namespace verisim::cli {

int command_bench(const std::vector<std::string>& arguments) {
  OwnOptions own("bench",
                 "Measures verisim and POV-Ray on the same scenes as whole processes, in turn. The ratio of their CPU "
                 "times is the verdict. Switches in POV-Ray's style go to both.");
  compare::BenchOptions options;
  std::string json, oracle, native;
  double minimum = 0;
  bool color = false, quiet = false;
  own.synopsis("SCENE... [options] [switches]")
      .summary("time and memory of verisim and POV-Ray")
      .example("verisim bench scene.pov +W320 +H240 +A0.3 --runs 5", "the middle of five runs of each")
      .section("Options");
  own.value("--runs N", options.runs, "runs of each program for each scene");
  own.value("--threads N", options.threads, "threads of each program");
  own.value("--time-limit X", options.time_limit, "seconds for one run");
  own.value("--json FILE", json, "write the figures as JSON");
  own.value("--min-ratio X", minimum,
            "exit status 1 unless POV-Ray's CPU time is at least this many times ours, in every scene");
  own.value("--oracle PROGRAM", oracle, "the POV-Ray program; default: povray in PATH");
  own.value("--native PROGRAM", native, "another verisim program; default: this one");
  own.flag("--color", color, "colour the table also when it does not go to a terminal");
  own.flag("--quiet", quiet, "no progress, only the table");
  const std::vector<std::string> words = own.parse(arguments);
  if (options.runs < 1) throw OptionError("--runs must be at least 1");
  const SuiteWords given = suite_words(words);
  const compare::Suite suite = compare::load_suite(given.what, given.defaults);
  if (suite.scenes.empty()) throw OptionError("no scene to measure");
  options.oracle.program = oracle;
  options.native_program = native.empty() ? own_program() : std::filesystem::path(native);
  if (!quiet)
    options.progress = [](const std::string& scene, int run) {
      std::fprintf(stderr, "%s, run %d\n", scene.c_str(), run);
    };
  try {
    const compare::Bench bench = compare::run_bench(suite, options);
    std::fputs(compare::bench_table(bench, color || isatty(STDOUT_FILENO) != 0).c_str(), stdout);
    if (!json.empty()) compare::write_report(compare::bench_json(bench), json);
    for (const compare::BenchScene& scene : bench.scenes)
      if (!scene.error.empty() || (minimum > 0 && scene.cpu_ratio < minimum)) return kDifferent;
    return kOk;
  } catch (const compare::OracleMissing& missing) {
    std::fprintf(stderr, "verisim bench: %s\n", missing.what());
    return kInputOutput;
  }
}

}  // namespace verisim::cli
