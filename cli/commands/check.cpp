// `verisim check`: reads scenes and says what is wrong with them.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/describe/diagnostics_json.h"
#include "cli/describe/dump.h"
#include "cli/describe/fixes.h"
#include "cli/describe/scene_findings.h"
#include "cli/frame/frame.h"
#include "cli/lints/lints.h"
#include "cli/sandbox/sandbox.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/reading/scene_words.h"
#include "compare/json_text.h"
#include "parser/source/suggest.h"
#include "tracer/base/whole_file.h"
#include "tracer/render/requirements.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

struct WantedCheck {
  bool json = false, dump = false, fix = false;
  std::string sarif;
  std::set<std::string_view> lints;
};

// What one scene gave.
struct Checked {
  fs::path scene;
  std::vector<parser::Diagnostic> messages;
  std::vector<LintFinding> lints;
  std::size_t errors = 0;
  int warnings = 0;
  bool whole = true;
  ExitStatus status = kOk;
};

std::string counted(std::size_t n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string summary(const Checked& checked) {
  const std::string errors = checked.status == kUnsupported ? "not supported"
                             : checked.errors               ? counted(checked.errors, "error")
                                                            : "no errors";
  std::string out = fmt::format("{}: {}, {}", checked.scene.string(), errors,
                                counted(static_cast<std::size_t>(checked.warnings), "warning"));
  if (!checked.lints.empty()) out += ", " + counted(checked.lints.size(), "lint");
  if (!checked.whole && checked.errors) out += "; reading stopped at the last error, there may be more";
  return out;
}

nlohmann::json as_json(const Checked& checked) {
  nlohmann::json report{{"scene", checked.scene.string()},
                        {"errors", checked.errors},
                        {"warnings", checked.warnings},
                        {"whole", checked.whole},
                        {"status", static_cast<int>(checked.status)}};
  report["diagnostics"] = nlohmann::json::array();
  for (const parser::Diagnostic& d : checked.messages) report["diagnostics"].push_back(cli::as_json(d));
  if (!checked.lints.empty()) report["lints"] = nlohmann::json::array();
  for (const LintFinding& f : checked.lints)
    report["lints"].push_back({{"file", f.file},
                               {"line", f.line},
                               {"column", f.column},
                               {"length", f.length},
                               {"name", f.lint->name},
                               {"message", f.message}});
  return report;
}

Checked check_scene(const Options& options, Console& console, Interrupt& interrupt, const SceneSource& scene,
                    const WantedCheck& wanted) {
  const Job job{options, console, interrupt, scene, animation(options)};
  Checked checked;
  checked.scene = scene.path;
  parser::ParseOptions parse = parse_options(job, job.animation.frame(0));
  const auto show = parse.message;
  parse.message = [&](const parser::Diagnostic& d) {
    checked.messages.push_back(d);
    if (!wanted.json) show(d);
  };
  // Taking a large scene apart takes as long as a good part of reading it, and the process ends anyway: the last one is
  // kept until then.
  static std::unique_ptr<parser::ParseResult>& kept = *new std::unique_ptr<parser::ParseResult>;
  kept = std::make_unique<parser::ParseResult>(parse_scene(job, parse));
  const parser::ParseResult& result = *kept;
  console.end_of_debug();
  checked.errors = result.errors.size();
  checked.warnings = result.warnings;
  checked.whole = result.whole;
  // A signal behind the end of parsing interrupts nothing: what was found is told.
  if (interrupt.flag() && (!result.scene || interrupt.limit_reached())) {
    checked.status = kInterrupted;
    return checked;
  }
  checked.status = result.scene ? kOk : kSceneErrors;
  for (const parser::Diagnostic& error : result.errors)
    if (error.severity == parser::Severity::unsupported) checked.status = kUnsupported;
  if (!result.scene) return checked;
  for (const parser::Diagnostic& finding : scene_findings(*result.scene)) {
    parse.message(finding);
    ++checked.warnings;
  }
  if (!wanted.lints.empty()) {
    std::vector<fs::path> files{scene.path};
    for (const fs::path& file : result.files_read)
      if (file != scene.path) files.push_back(file);
    const auto text = [&](const fs::path& file) {
      return file == scene.path && scene.text ? scene.text : whole_file(file);
    };
    checked.lints = *find_lints({*result.scene, std::move(files), text}, wanted.lints);
    for (const LintFinding& finding : checked.lints)
      if (!wanted.json) console.line(Stream::warning, format(finding));
  }
  try {
    render::check_supported(*result.scene, render_options(job, {0, options.width - 1, 0, options.height - 1}));
  } catch (const render::Unsupported& missing) {
    parser::Diagnostic d;
    d.severity = parser::Severity::unsupported;
    d.code = parser::Code::unsupported;
    d.file = missing.place.file ? *missing.place.file : scene.path.string();
    d.line = missing.place.line;
    d.column = missing.place.column;
    d.message = missing.what();
    parse.message(d);
    checked.status = kUnsupported;
  }
  if (wanted.dump) std::puts(compare::json_text(SceneDump().scene(*result.scene), 1).c_str());
  return checked;
}

// The scenes that a word names: one, or all below a folder, in alphabetical order.
std::vector<SceneSource> scenes_of(Options& options, const std::string& word) {
  std::error_code error;
  if (fs::is_directory(word, error)) {
    std::vector<SceneSource> scenes;
    for (fs::recursive_directory_iterator i(word, fs::directory_options::skip_permission_denied, error), end;
         !error && i != end; i.increment(error))
      if (i->is_regular_file(error) && parser::lowered(i->path().extension().string()) == ".pov")
        scenes.push_back({i->path(), std::nullopt});
    std::sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    if (scenes.empty()) throw std::runtime_error(fmt::format("no scenes (*.pov) below the folder '{}'", word));
    return scenes;
  }
  options.input_file = word;
  SceneSource scene = open_scene(options);
  if (!scene.found()) throw std::runtime_error(fmt::format("cannot find the scene '{}'", word));
  return {std::move(scene)};
}

int explain_code(const std::string& wanted) {
  if (wanted == "list") {
    for (const parser::CodeEntry& e : parser::all_codes())
      std::printf("%-24.*s %.*s\n", static_cast<int>(e.name.size()), e.name.data(), static_cast<int>(e.title.size()),
                  e.title.data());
    for (const Lint& lint : all_lints())
      std::fputs(fmt::format("{:<24} {} (with --lint)\n", lint.name, lint.title).c_str(), stdout);
    return kOk;
  }
  if (const Lint* lint = lint_named(wanted)) {
    std::fputs(explanation(*lint).c_str(), stdout);
    return kOk;
  }
  const std::optional<parser::Code> code = parser::code_named(wanted);
  if (!code) {
    std::vector<std::string_view> names;
    for (const parser::CodeEntry& e : parser::all_codes()) names.push_back(e.name);
    const std::string_view likely = parser::nearest(wanted, names);
    throw OptionError(fmt::format(
        "--explain {}: no such code; {}", wanted,
        likely.empty() ? "'verisim check --explain list' names them all" : fmt::format("did you mean '{}'?", likely)));
  }
  std::fputs(parser::explanation(parser::entry(*code)).c_str(), stdout);
  return kOk;
}

}  // namespace

int command_check(const std::vector<std::string>& arguments) {
  Options options;
  WantedCheck wanted;
  std::string code;
  std::vector<std::string> lints;
  OwnOptions own("check",
                 "Reads scenes without rendering them and says what is wrong with them, as file:line:column: severity: "
                 "message [code], with the line and what is meant underlined. A folder stands for all scenes below it. "
                 "Exit status 0: no errors, 3: errors, 4: something is not supported. All switches of POV-Ray's are "
                 "taken; those that decide how a picture looks change nothing here.");
  own.synopsis("SCENE...|FOLDER [options] [switches]")
      .summary("read scenes and report what is wrong with them")
      .example("verisim check scene.pov", "every error with its place")
      .example("verisim check --explain unclosed-block", "what a code means, with an example")
      .example("verisim check scene.pov --fix", "correct what can be corrected without doubt")
      .example("verisim check scene.pov --json", "the same for programs")
      .example("verisim check - --stdin-name scene.pov < buffer", "text that is not saved yet")
      .section("Options");
  own.flag("--json", wanted.json, "print the diagnostics as JSON to standard output");
  own.flag("--dump", wanted.dump, "print the evaluated scene as JSON to standard output (docs/dump.md)");
  own.flag("--fix", wanted.fix, "correct in the files what can be corrected without doubt, and check again");
  own.value("--sarif FILE", wanted.sarif, "write the diagnostics to this file as SARIF, which code hosts show");
  own.values("--lint NAME", lints,
             "look for what is allowed and yet mostly a mistake, too: unused-name, shadowed-name, skipped-directive, "
             "constant-in-loop, "
             "coincident-surfaces, light-inside, inward-normals, hidden-texture, ambient-with-radiosity; "
             "all or none");
  own.value("--explain CODE", code, "say what a diagnostic's code means, with an example; 'list' names all codes");
  add_scene_options(own, options);
  refuse_render_options(own);
  own.switches({Topic::scene, Topic::size, Topic::animation, Topic::messages});
  const std::vector<std::string> files = apply_words(options, with_folders(own.parse(arguments)));
  if (!code.empty()) return explain_code(code);
  wanted.lints = wanted_lints(lints);
  if (files.empty() && options.input_file.empty() && !options.stdin_name.empty()) options.input_file = "-";
  if (files.empty() && options.input_file.empty()) throw OptionError("no scene: verisim check SCENE [switches]");
  validate(options);
  std::vector<SceneSource> scenes;
  for (const std::string& word : files.empty() ? std::vector<std::string>{options.input_file} : files)
    for (SceneSource& scene : scenes_of(options, word)) scenes.push_back(std::move(scene));

  if (wants_sandbox()) {
    Policy policy = policy_of(options, scenes);
    confine_scene(options, policy);
    if (!wanted.sarif.empty() && wanted.sarif != "-") grant_output(policy, wanted.sarif);
    for (const SceneSource& scene : scenes)
      if (wanted.fix) grant_output(policy, scene.path);
    enter_sandbox(policy);
  }
  Console console(options, Style::verisim);
  Interrupt interrupt(watch(options, console));
  ExitStatus status = kOk;
  nlohmann::json reports = nlohmann::json::array();
  std::vector<parser::Diagnostic> all;
  std::vector<OtherFinding> others;
  for (const SceneSource& scene : scenes) {
    Checked checked = check_scene(options, console, interrupt, scene, wanted);
    // A correction may bring to light what stood behind the mistake.
    for (int again = 0; wanted.fix && again < 100 && apply_fixes(checked.messages, console); ++again)
      checked = check_scene(options, console, interrupt, scene, wanted);
    if (checked.status == kInterrupted) {
      if (wanted.json) console.always("interrupted");  // else the parser's message has been shown
      return kInterrupted;
    }
    status = std::max(status, checked.status);
    if (wanted.json)
      reports.push_back(as_json(checked));
    else if (!wanted.dump)
      console.line(Stream::statistic, summary(checked));
    all.insert(all.end(), checked.messages.begin(), checked.messages.end());
    for (const LintFinding& f : checked.lints)
      others.push_back({f.lint->name, f.lint->title, f.lint->text, f, f.message});
  }
  if (wanted.json && !wanted.dump) std::puts(compare::json_text(scenes.size() == 1 ? reports[0] : reports, 2).c_str());
  if (!wanted.sarif.empty()) write_sarif(all, others, wanted.sarif);
  return status;
}

}  // namespace verisim::cli
