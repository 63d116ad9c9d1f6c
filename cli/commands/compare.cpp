// `verisim compare`: scenes rendered by verisim and by POV-Ray, every pixel compared.
#include "compare/compare.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <thread>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/console/interrupt.h"
#include "cli/sandbox/sandbox.h"
#include "cli/commands/layer_limits.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/process_limits.h"
#include "cli/commands/own_program.h"
#include "cli/settings/reading/scene_words.h"
#include "compare/oracle/content_hash.h"
#include "compare/regression/programs/command_renderer.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

void show_progress(const compare::Progress& progress) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  if (progress.finished) {
    const compare::SceneResult& scene = *progress.finished;
    if (terminal) std::fputs("\r\x1b[K", stderr);
    std::fprintf(stderr, "%4d/%d  %-13s %s%s%s\n", progress.done, progress.total, compare::to_string(scene.status),
                 scene.request.name.c_str(), scene.reason.empty() ? "" : ": ", scene.reason.c_str());
  } else if (terminal) {
    std::fprintf(stderr, "\r%d of %d, %d running", progress.done, progress.total, progress.running);
    if (progress.seconds_left >= 0) std::fprintf(stderr, ", about %.0f s left", progress.seconds_left);
    std::fputs("\x1b[K", stderr);
  }
}

// Runs of one scene differ whatever the seed of the first is: noise that repeats itself passes for none.
compare::NativeRenderer seeded(compare::NativeRenderer renderer, std::uint64_t seed) {
  if (seed == 0) return renderer;
  return [renderer = std::move(renderer), seed](compare::NativeRequest request) {
    request.seed = seed + static_cast<std::uint64_t>(request.run);
    return renderer(request);
  };
}

// The program that is judged: this one, another verisim, or a POV-Ray. Returns its name.
std::string choose_renderer(const std::string& program, std::uint64_t seed, compare::RunOptions& run) {
  std::vector<std::string> extra;
  if (wants_sandbox()) extra.push_back("--sandbox=" + process_limits.sandbox);
  compare::OracleProgram judged;
  if (program.empty()) {
    judged.path = own_program(), judged.name = "verisim", judged.version = VERISIM_VERSION;
    compare::ContentHash hash;
    hash.add_file(judged.path);
    judged.version_text = hash.hex();
  } else {
    compare::OracleOptions options = run.oracle;
    options.program = program;
    judged = compare::find_oracle(options);
  }
  run.native_version = judged.version, run.native_identity = judged.version_text;
  if (judged.name == "verisim") {
    run.native = seeded(compare::native_program(judged.path, extra), seed);
    run.tags = compare::tags_of_program(judged.path);
    return program.empty() ? "verisim" : fmt::format("verisim ({})", program);
  }
  compare::OracleOptions limits = run.oracle;
  limits.time_limit = run.native_time_limit;
  run.native = compare::povray_renderer(judged, limits);
  return "POV-Ray " + judged.version;
}

compare::NativeRenderer renderer_of_command(const char* option, const std::string& command) {
  try {
    return compare::command_renderer(command);
  } catch (const std::invalid_argument& error) {
    throw OptionError(fmt::format("{}: {}", option, error.what()));
  }
}
std::string program_name(const std::string& command) {
  return fs::path(command.substr(0, command.find(' '))).filename().string();
}

// Who says what the reference's pixels show. Another verisim knows itself; a POV-Ray's pixels, or stored ones, should
// show what this program sees in the scene, which is worth knowing where another program is judged.
void choose_witness(const std::string& oracle, bool judges_this_program, compare::RunOptions& run) {
  const bool other_verisim =
      !oracle.empty() && run.baseline.empty() && compare::find_oracle(run.oracle).name == "verisim";
  if (other_verisim || !judges_this_program)
    run.reference_tags = compare::tags_of_program(other_verisim ? fs::path(oracle) : own_program());
}

// The same for a command line. Nothing is known of what its pixels show.
std::string choose_command(const std::string& command, compare::RunOptions& run) {
  run.native = renderer_of_command("--test", command);
  run.native_version = run.native_identity = command;
  return program_name(command);
}

// Who may stand beside the judged program in front of a photograph.
void add_others(compare::RunOptions& run) {
  run.beside["path"] = compare::native_program(own_program(), {"--integrator", "path"});
  run.beside["povray"] = [options = run.oracle](const compare::NativeRequest& request) {
    return compare::povray_renderer(compare::find_oracle(options), options)(request);
  };
}

// POV-Ray sleeps for a third of a second when it starts: small scenes wait for it side by side. Large ones take the
// memory and the threads that there are one after the other.
int jobs_for(const compare::Suite& suite, bool waits) {
  constexpr int kSmall = 320 * 240, kWaiting = 12;
  for (const compare::SceneRequest& scene : suite.scenes)
    if (static_cast<std::int64_t>(scene.width) * scene.height > kSmall) return 1;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return waits ? kWaiting * cores : cores;
}

// 0: what is written to is no terminal, and lines may be as long as they are.
int terminal_columns(std::FILE* file) {
  winsize size{};
  if (!isatty(fileno(file))) return 0;
  return ioctl(fileno(file), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 120;
}

// Each report by itself: one that cannot be written does not cost the others.
bool write_reports(const compare::Run& run,
                   const std::vector<std::pair<std::string, std::string (*)(const compare::Run&)>>& reports) {
  bool written = true;
  for (const auto& [file, text] : reports) {
    if (file.empty()) continue;
    try {
      compare::write_report(text(run), file);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "verisim compare: %s\n", error.what());
      written = false;
    }
  }
  return written;
}

// Said before a long run, not only after it.
void warn_of_unwritable_reports(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (file.empty()) continue;
    const fs::path folder = fs::absolute(file).parent_path();
    if (access(folder.c_str(), W_OK) != 0)
      std::fprintf(stderr,
                   "verisim compare: warning: %s: the folder cannot be written, the run goes on without this report\n",
                   file.c_str());
  }
}

// What the options say.
struct CompareOptions {
  compare::RunOptions run;
  compare::Filter filter;
  std::string json, junit, html, markdown, oracle, oracle_cache, work, baseline, native, test, reference, scene_class;
  std::vector<std::string> previous, layers;
  bool github = false, no_cache = false, failed_only = false, quiet = false, color = false, update = false,
       no_explain = false;
  std::uint64_t seed = 0;

  CompareOptions() { run.native_time_limit = 600, run.jobs = 0; }
};

void declare_options(OwnOptions& own, CompareOptions& o) {
  own.synopsis("SCENE|FOLDER|MANIFEST... [options] [switches]")
      .summary("render with verisim and POV-Ray and compare every pixel")
      .example("verisim compare scene.pov +W320 +H240 -A", "one scene")
      .example("verisim compare scenes/ --html report.html --json report.json", "all scenes below a folder")
      .section("Reports");
  own.value("--json FILE", o.json, "write the report as JSON (- for standard output, as for all reports)");
  own.value("--junit FILE", o.junit, "write the report as JUnit XML");
  own.value("--html FILE", o.html, "write the report as one HTML page");
  own.value("--markdown FILE", o.markdown, "write the report as Markdown");
  own.flag("--github", o.github, "print annotations for GitHub Actions");
  own.flag("--no-explain", o.no_explain,
           "do not look for what the wrong pixels of a scene that differs have in common");
  own.flag("--explain-all", o.run.always_blame, "look for it in scenes that do not differ, too");
  own.flag("--color", o.color, "colour the table also when it does not go to a terminal");
  own.flag("--quiet", o.quiet, "no progress, only the table");
  own.section("Which scenes");
  own.values("--name PATTERN", o.filter.names,
             "only scenes whose name matches this pattern or contains it (may be given again)");
  own.values("--tag TAG", o.filter.tags, "only scenes with this tag (may be given again)");
  own.flag("--failed", o.failed_only, "only scenes that failed in the report of --previous (the last one)");
  own.values("--previous FILE", o.previous,
             "JSON report of an earlier run, for the trend; given again, oldest first, the course over many runs");
  own.section("How they are rendered");
  own.value(
      "--jobs N", o.run.jobs,
      "scenes at a time; without it as many as keep the cores busy: small scenes wait for POV-Ray side by side, which "
      "sleeps when it starts");
  own.value("--threads N", o.run.native_threads, "threads of verisim for one scene; 0: all cores");
  own.flag("--replay", o.run.replay, "both serial, with POV-Ray's random streams");
  own.value(
      "--sandbox[=strict]", process_limits.sandbox,
      "verisim's own renders run in the sandbox of `verisim render --sandbox`, and nothing is looked for in wrong "
      "pixels: strict, best-effort or off");
  own.value("--seed N", o.seed, "another sequence of random numbers for verisim");
  own.value("--runs N", o.run.runs,
            "renders of a stochastic scene on each side for Welch's test, 4 if not told otherwise; 1: no such test");
  own.value("--class CLASS", o.scene_class,
            "judge all scenes as deterministic or stochastic in the place of what verisim finds in them");
  own.value("--work FOLDER", o.work, "keep pictures and results in this folder");
  own.flag("--resume", o.run.resume, "go on with the run in --work that was broken off");
  own.value("--native-time-limit X", o.run.native_time_limit, "seconds for one render by verisim");
  own.section("What they are compared with");
  own.value("--oracle PROGRAM", o.oracle, "a POV-Ray, or another verisim; default: povray in PATH");
  own.value("--reference COMMAND", o.reference,
            "any renderer in the place of POV-Ray, as a command like that of --test; needs no POV-Ray");
  own.value("--oracle-cache FOLDER", o.oracle_cache, "where POV-Ray's renders are kept");
  own.flag("--no-cache", o.no_cache, "render with POV-Ray anew");
  own.value("--time-limit X", o.run.oracle.time_limit, "seconds for one render by POV-Ray");
  own.value("--baseline FOLDER", o.baseline, "compare with the stored pictures in this folder instead of POV-Ray");
  own.flag("--update", o.update,
           "say what changed against --baseline, then store verisim's pictures there; needs no POV-Ray");
  own.section("What is judged");
  own.value("--native PROGRAM", o.native, "another program to be judged, a verisim or a POV-Ray; default: this one");
  own.value("--test COMMAND", o.test,
            "any renderer to be judged, as a command: \"render {scene} {out} {width} {height}\"; also {threads}, "
            "{seed}, {switches}");
  own.values("--layer LAYER:LIMITS", o.layers, compare::kLayerHelp);
}

void check_options(const CompareOptions& o) {
  if (o.update && o.baseline.empty()) throw OptionError("--update needs --baseline FOLDER");
  if (o.run.runs < 1 || o.run.runs > 64) throw OptionError("--runs must be 1 to 64");
  if (!o.scene_class.empty() && o.scene_class != "deterministic" && o.scene_class != "stochastic")
    throw OptionError("--class must be deterministic or stochastic");
  if (o.run.resume && o.work.empty()) throw OptionError("--resume needs --work FOLDER");
  if (o.failed_only && o.previous.empty()) throw OptionError("--failed needs --previous FILE");
  if (wants_sandbox() && !o.test.empty()) throw OptionError("--sandbox is verisim's: not with --test");
  if (!o.test.empty() && !o.native.empty())
    throw OptionError("--native and --test name the same side; give one of them");
  if (!o.reference.empty() && (!o.baseline.empty() || !o.oracle.empty()))
    throw OptionError("--reference, --oracle and --baseline name the same side; give one of them");
  if (o.run.jobs < 0) throw OptionError("--jobs must be at least 1");
}

// The scenes that are left, with what the options say of all.
compare::Suite wanted_suite(const std::vector<std::string>& words, CompareOptions& o) {
  const std::vector<compare::LayerRule> rules = layer_options(o.layers);
  const SuiteWords given = suite_words(words);
  compare::Suite suite = compare::load_suite(given.what, given.defaults);
  for (const std::string& warning : suite.warnings) std::fprintf(stderr, "verisim compare: %s\n", warning.c_str());
  o.filter.failed_last_time = o.failed_only;
  if (!o.previous.empty()) o.filter.last_report = o.previous.back();
  suite = compare::filter(suite, o.filter);
  if (suite.scenes.empty()) throw OptionError("no scene is left to compare");

  for (compare::SceneRequest& scene : suite.scenes)  // before those of the manifest
    scene.layers.insert(scene.layers.begin(), rules.begin(), rules.end());
  if (!o.scene_class.empty())
    for (compare::SceneRequest& scene : suite.scenes)
      scene.scene_class =
          o.scene_class == "stochastic" ? compare::SceneClass::stochastic : compare::SceneClass::deterministic;
  return suite;
}

// What the run compares with and keeps.
void prepare_run(const compare::Suite& suite, CompareOptions& o) {
  const bool waits = o.baseline.empty() && o.reference.empty();
  if (o.run.jobs == 0) o.run.jobs = jobs_for(suite, waits);
  o.run.oracle.program = o.oracle;
  o.run.oracle.cache = o.oracle_cache;
  o.run.oracle.use_cache = !o.no_cache;
  o.run.work = o.work;
  o.run.baseline = o.baseline;
  o.run.whole_suite = o.filter.names.empty() && o.filter.tags.empty() && !o.failed_only;
  o.run.earlier_reports.assign(o.previous.begin(), o.previous.end());
  if (!o.previous.empty()) o.run.previous_report = o.previous.back();
  if (!o.quiet) o.run.progress = show_progress;
}

// Who is judged, by whom, and who says what pixels show. Returns the name of who is judged.
std::string choose_programs(CompareOptions& o) {
  const std::string test_name =
      o.test.empty() ? choose_renderer(o.native, o.seed, o.run) : choose_command(o.test, o.run);
  if (!o.reference.empty()) {
    o.run.reference = renderer_of_command("--reference", o.reference);
    o.run.reference_identity = o.reference, o.run.reference_name = program_name(o.reference);
  }
  add_others(o.run);
  if (o.no_explain || wants_sandbox())
    o.run.tags = nullptr;
  else
    choose_witness(o.oracle, o.test.empty() && o.native.empty(), o.run);
  return test_name;
}

// False: a report could not be written.
bool tell(const compare::Run& result, const CompareOptions& o) {
  const bool report_to_stdout =
      o.json == "-" || o.junit == "-" || o.html == "-" || o.markdown == "-";  // which is then the report's alone
  std::FILE* const people = report_to_stdout ? stderr : stdout;
  std::fputs(compare::terminal_table(result, o.color || isatty(fileno(people)) != 0, terminal_columns(people)).c_str(),
             people);
  if (o.github) std::fputs(compare::github_annotations(result).c_str(), stdout);
  return write_reports(result, {{o.json, compare::json_report},
                                {o.junit, compare::junit_report},
                                {o.html, compare::html_report},
                                {o.markdown, compare::markdown_report}});
}

int keep_as_baseline(const compare::Run& result, const CompareOptions& o, bool written) {
  for (const std::string& line : compare::update_baseline(result, o.baseline, true)) std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  compare::update_baseline(result, o.baseline, false);
  const auto without_picture = [](const compare::SceneResult& scene) {
    return scene.failed() && scene.status != compare::Status::removed && scene.native_picture.empty();
  };
  return !written ? kInputOutput : std::ranges::any_of(result.scenes, without_picture) ? kDifferent : kOk;
}

}  // namespace

int command_compare(const std::vector<std::string>& arguments) {
  OwnOptions own("compare",
                 "Renders scenes with verisim and POV-Ray and compares every pixel. Scenes are files, all scenes below "
                 "a folder, or those of a manifest (verisim.toml). Switches in POV-Ray's style (+W320 +A0.3) go to "
                 "both.");
  CompareOptions o;
  declare_options(own, o);
  const std::vector<std::string> words = own.parse(arguments);
  if (words.empty()) throw OptionError("name scenes, folders or manifests (verisim.toml)");
  check_options(o);
  const compare::Suite suite = wanted_suite(words, o);
  prepare_run(suite, o);
  Interrupt interrupt;
  o.run.cancel = &interrupt.flag();

  warn_of_unwritable_reports({o.json, o.junit, o.html, o.markdown});
  try {
    const std::string test_name = choose_programs(o);
    compare::Run result = compare::run_suite(suite, o.run);
    result.test_name = test_name;
    const bool written = tell(result, o);
    if (result.cancelled) return kInterrupted;
    if (o.update) return keep_as_baseline(result, o, written);
    return !written ? kInputOutput : result.summary.failed() ? kDifferent : kOk;
  } catch (const compare::OracleMissing& missing) {
    std::fprintf(stderr, "verisim compare: %s\n", missing.what());
    return kInputOutput;
  }
}

}  // namespace verisim::cli
