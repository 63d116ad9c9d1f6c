// `verisim compare`: scenes rendered by verisim and by POV-Ray, every pixel compared.
#include "compare/compare.h"

#include <unistd.h>

#include <cstdio>
#include <thread>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/own_options.h"
#include "cli/own_program.h"
#include "cli/scene_words.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

void show_progress(const compare::Progress& progress) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  if (progress.finished) {
    const compare::SceneResult& scene = *progress.finished;
    if (terminal) std::fputs("\r\x1b[K", stderr);
    std::fprintf(stderr, "%4d/%d  %-13s %s%s%s\n", progress.done, progress.total, compare::to_string(scene.status), scene.request.name.c_str(), scene.reason.empty() ? "" : ": ",
                 scene.reason.c_str());
  } else if (terminal) {
    std::fprintf(stderr, "\r%d of %d, %d running", progress.done, progress.total, progress.running);
    if (progress.seconds_left >= 0) std::fprintf(stderr, ", about %.0f s left", progress.seconds_left);
    std::fputs("\x1b[K", stderr);
  }
}

}  // namespace

int command_compare(const std::vector<std::string>& arguments) {
  OwnOptions own("compare", "Renders scenes with verisim and POV-Ray and compares every pixel: verisim compare SCENE|FOLDER|MANIFEST... [switches]. Switches in POV-Ray's style (+W320 +A0.3) go to both.");
  compare::RunOptions run;
  compare::Filter filter;
  std::string json, junit, html, markdown, oracle, oracle_cache, work, baseline, previous, native;
  bool github = false, no_cache = false, failed_only = false, quiet = false, color = false, update = false;
  std::uint64_t seed = 0;
  own.value("--json", json, "Write the report as JSON to this file");
  own.value("--junit", junit, "Write the report as JUnit XML to this file");
  own.value("--html", html, "Write the report as one HTML page to this file");
  own.value("--markdown", markdown, "Write the report as Markdown to this file");
  own.flag("--github", github, "Print annotations for GitHub Actions");
  own.values("--name", filter.names, "Only scenes whose name matches this pattern or contains it (may be given again)");
  own.values("--tag", filter.tags, "Only scenes with this tag (may be given again)");
  own.flag("--failed", failed_only, "Only scenes that failed in the report of --previous");
  own.value("--previous", previous, "JSON report of an earlier run, for the trend");
  own.value("--jobs", run.jobs, "Scenes at a time");
  own.value("--threads", run.native_threads, "Threads of verisim for one scene; 0: all cores");
  own.flag("--replay", run.replay, "Both serial, with POV-Ray's random streams");
  own.value("--seed", seed, "Another sequence of random numbers for verisim");
  own.value("--work", work, "Keep pictures and results in this folder");
  own.flag("--resume", run.resume, "Go on with the run in --work that was broken off");
  own.value("--baseline", baseline, "Compare with the stored pictures in this folder instead of POV-Ray");
  own.flag("--update-baseline", update, "Compare with POV-Ray, then store verisim's pictures in --baseline");
  own.value("--oracle", oracle, "The POV-Ray program; default: povray in PATH");
  own.value("--oracle-cache", oracle_cache, "Folder of POV-Ray's cached renders");
  own.flag("--no-cache", no_cache, "Render with POV-Ray anew");
  own.value("--time-limit", run.oracle.time_limit, "Seconds for one render by POV-Ray");
  own.value("--native", native, "Another verisim program to compare with POV-Ray; default: this one");
  own.flag("--color", color, "Colour the table also when it does not go to a terminal");
  own.flag("--quiet", quiet, "No progress, only the table");
  const std::vector<std::string> words = own.parse(arguments);
  if (words.empty()) throw OptionError("name scenes, folders or manifests (verisim.toml)");
  if (update && baseline.empty()) throw OptionError("--update-baseline needs --baseline FOLDER");
  if (run.resume && work.empty()) throw OptionError("--resume needs --work FOLDER");
  if (failed_only && previous.empty()) throw OptionError("--failed needs --previous FILE");
  if (run.jobs < 1) throw OptionError("--jobs must be at least 1");

  const SuiteWords given = suite_words(words);
  compare::Suite suite = compare::load_suite(given.what, given.defaults);
  for (const std::string& warning : suite.warnings) std::fprintf(stderr, "verisim compare: %s\n", warning.c_str());
  filter.failed_last_time = failed_only;
  filter.last_report = previous;
  suite = compare::filter(suite, filter);
  if (suite.scenes.empty()) throw OptionError("no scene is left to compare");

  std::vector<std::string> extra;
  if (run.replay) extra.push_back("--replay");
  if (seed != 0) extra.push_back(fmt::format("--seed={}", seed));
  run.native = compare::native_program(native.empty() ? own_program() : fs::path(native), extra);
  run.native_version = VERISIM_VERSION;
  run.oracle.program = oracle;
  run.oracle.cache = oracle_cache;
  run.oracle.use_cache = !no_cache;
  run.work = work;
  if (!update) run.baseline = baseline;
  run.previous_report = previous;
  if (!quiet) run.progress = show_progress;
  Interrupt interrupt;
  run.cancel = &interrupt.flag();

  try {
    const compare::Run result = compare::run_suite(suite, run);
    std::fputs(compare::terminal_table(result, color || isatty(STDOUT_FILENO) != 0).c_str(), stdout);
    if (github) std::fputs(compare::github_annotations(result).c_str(), stdout);
    if (!json.empty()) compare::write_report(compare::json_report(result), json);
    if (!junit.empty()) compare::write_report(compare::junit_report(result), junit);
    if (!html.empty()) compare::write_report(compare::html_report(result), html);
    if (!markdown.empty()) compare::write_report(compare::markdown_report(result), markdown);
    if (result.cancelled) return kInterrupted;
    if (update)
      for (const std::string& line : compare::update_baseline(result, baseline, false)) std::printf("%s\n", line.c_str());
    return result.summary.failed() ? kDifferent : kOk;
  } catch (const compare::OracleMissing& missing) {
    std::fprintf(stderr, "verisim compare: %s\n", missing.what());
    return kInputOutput;
  }
}

}  // namespace verisim::cli
