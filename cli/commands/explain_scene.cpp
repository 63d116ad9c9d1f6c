#include "cli/commands/explain_scene.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/commands.h"
#include "cli/commands/own_program.h"
#include "cli/console/interrupt.h"
#include "cli/settings/reading/own_options.h"
#include "compare/compare.h"
#include "compare/oracle/process.h"
#include "compare/reduce/reduce.h"
#include "tracer/base/output_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// How a file begins that was made here, and so may be written over.
constexpr std::string_view kReducedMark = "// Reduced by verisim explain --reduce";

compare::RunOptions run_options(const SceneExplanation& o, Interrupt& interrupt) {
  compare::RunOptions run;
  run.oracle.program = o.oracle;
  const fs::path program = o.native.empty() ? own_program() : fs::absolute(compare::find_program(o.native));
  if (program.empty() || !fs::exists(program)) throw OptionError(fmt::format("--native {}: no such program", o.native));
  run.native = compare::native_program(program, {});
  run.tags = compare::tags_of_program(own_program());  // an older program may know less of its pixels
  run.native_version = VERISIM_VERSION;
  run.replay = o.replay;
  run.always_blame = true;
  run.native_time_limit = 600;
  run.cancel = &interrupt.flag();
  return run;
}

int suspects(const compare::Suite& suite, const compare::RunOptions& run) {
  const compare::Run result = compare::run_suite(suite, run);
  if (result.cancelled) return kInterrupted;
  if (result.scenes.empty()) return kInputOutput;
  const compare::SceneResult& scene = result.scenes[0];
  std::fputs(compare::terminal_blame(scene).c_str(), stdout);
  return scene.status == compare::Status::unsupported ? kUnsupported : scene.failed() ? kDifferent : kOk;
}

// Where the reduced scene goes, made sure before the work: nothing that somebody else made is lost.
fs::path reduced_file(const SceneExplanation& o, const fs::path& scene, bool from_stream) {
  fs::path out = o.reduce_to;
  if (out.empty()) out = from_stream ? fs::path("reduced.pov") : fs::path(scene).replace_extension(".reduced.pov");
  std::string first;
  if (std::ifstream in(out); in && std::getline(in, first) && !first.starts_with(kReducedMark))
    throw OptionError(
        fmt::format("{} is there already and was not made by --reduce: name another file with "
                    "--reduce-to FILE",
                    out.string()));
  require_writable(out);
  return out;
}

void show_reduction(const compare::ReduceProgress& progress) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r%zu of %zu lines left, %zu candidates, %.0f s\x1b[K", progress.lines, progress.lines_before,
               progress.tried, progress.seconds);
}

// The switches that show the difference.
std::vector<std::string> shown_by(const compare::SceneRequest& scene, const compare::Reduction& small) {
  std::vector<std::string> out{fmt::format("+W{}", small.frame.width), fmt::format("+H{}", small.frame.height)};
  for (const auto* switches : {&scene.switches, &small.frame.switches})
    for (const std::string& s : *switches) out.push_back(compare::shell_quoted(s));
  if (small.replay) out.emplace_back("--replay");
  return out;
}

void write_reduced(const compare::Reduction& small, const compare::SceneRequest& scene, const fs::path& file) {
  std::string words = compare::in_words(small.left);
  std::replace(words.begin(), words.end(), '\n', ' ');
  write_text_file(
      file, fmt::format("{} from {}: {}\n// verisim compare {} {}\n{}", kReducedMark, scene.scene.filename().string(),
                        words, file.filename().string(), fmt::join(shown_by(scene, small), " "), small.text));
  std::printf("%s: %s\n", scene.name.c_str(), compare::in_words(small.difference).c_str());
  std::printf("reduced from %zu to %zu lines in %.0f s (%zu candidates%s): %s\n", small.lines_before, small.lines,
              small.seconds, small.tried, small.complete ? "" : "; there was no time for more", file.c_str());
  constexpr std::size_t kShort = 60;
  if (small.lines <= kShort) std::printf("\n%s\n", small.text.c_str());
}

int nothing_to_reduce(const compare::Reduction& small, double seconds) {
  if (small.difference.kind == compare::Difference::Kind::undecided) {
    std::fprintf(stderr,
                 "verisim explain: a program came to no end within %.0f s; --seconds N gives more time, a smaller "
                 "picture (+W, +H) needs less\n",
                 seconds / 3);
    return kDifferent;
  }
  if (!small.difference.message.empty()) {
    std::printf("verisim and POV-Ray both refuse the scene: there is nothing to reduce\n%s\n",
                small.difference.message.c_str());
    return kOk;
  }
  std::printf("verisim and POV-Ray draw the same picture%s: there is nothing to reduce\n",
              small.random ? " where both draw the same random numbers (--replay)" : "");
  return kOk;
}

int reduce(const compare::SceneRequest& scene, compare::RunOptions run, const SceneExplanation& o, const fs::path& file,
           Interrupt& interrupt) {
  compare::ReduceOptions options;
  options.native = run.native, options.oracle = run.oracle, options.replay = run.replay, options.seconds = o.seconds;
  options.progress = show_reduction;
  options.cancel = run.cancel;
  const compare::Reduction small = compare::reduce_scene(scene, options);
  if (isatty(STDERR_FILENO) != 0) std::fputs("\r\x1b[K", stderr);
  using Kind = compare::Difference::Kind;
  const bool interrupted = interrupt.flag();
  if (interrupted) interrupt.orderly_end();
  if (small.difference.kind == Kind::none || small.difference.kind == Kind::undecided)
    return interrupted ? kInterrupted : nothing_to_reduce(small, o.seconds);
  write_reduced(small, scene, file);
  if (interrupted) return kInterrupted;
  std::fflush(stdout);
  if (small.left.kind != Kind::picture) return kDifferent;
  compare::SceneRequest again = scene;
  again.scene = fs::absolute(file), again.name = file.filename().string();
  again.width = small.frame.width, again.height = small.frame.height;
  again.switches.insert(again.switches.end(), small.frame.switches.begin(), small.frame.switches.end());
  run.replay = small.replay;
  run.runs = 1;
  constexpr double kRenders = 3;  // ours twice, POV-Ray's twice, some of them side by side
  run.native_time_limit = run.oracle.time_limit = std::max(2.0, (o.seconds - small.seconds) / kRenders);
  const int status = suspects({{again}, {}}, run);
  return status == kOk ? kDifferent : status;  // what the verdict forgives is a difference all the same
}

}  // namespace

int explain_scene(const std::vector<std::string>& words, const SceneExplanation& o) {
  if (!(o.seconds >= 5)) throw OptionError("--seconds must be at least 5");
  const SuiteWords given = suite_words(words);
  const compare::Suite suite = compare::load_suite(given.what, given.defaults);
  Interrupt interrupt;
  try {
    const compare::RunOptions run = run_options(o, interrupt);
    if (!o.reduce) return suspects(suite, run);
    if (suite.scenes.size() != 1 || suite.scenes[0].reference || !suite.scenes[0].passes.empty())
      throw OptionError("--reduce takes one scene, and no stored picture or passes of a manifest");
    const fs::path file = reduced_file(o, given.what[0], !given.spooled.empty());
    return reduce(suite.scenes[0], run, o, file, interrupt);
  } catch (const compare::OracleMissing& missing) {
    std::fprintf(stderr, "verisim explain: %s\n", missing.what());
    return kInputOutput;
  }
}

}  // namespace verisim::cli
