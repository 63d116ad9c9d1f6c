// `verisim check`: reads a scene and says what is wrong with it.
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/describe/diagnostic_json.h"
#include "cli/describe/dump.h"
#include "cli/frame/frame.h"
#include "cli/settings/own_options.h"
#include "cli/settings/scene_words.h"
#include "tracer/render/requirements.h"

namespace verisim::cli {
int command_check(const std::vector<std::string>& arguments) {
  Options options;
  bool json = false, dump = false;
  OwnOptions own("check",
                 "Reads a scene without rendering it and says what is wrong with it, as file:line:column: severity: "
                 "message, with the line and a caret. Exit status 0: no errors, 3: errors, 4: something is not "
                 "supported. All switches of POV-Ray's are taken; those that decide how a picture looks change nothing "
                 "here.");
  own.synopsis("SCENE [options] [switches]")
      .summary("read a scene and report what is wrong with it")
      .example("verisim check scene.pov", "every error with its place")
      .example("verisim check scene.pov --json", "the same for programs")
      .example("verisim check - --stdin-name scene.pov < buffer", "text that is not saved yet")
      .section("Options");
  own.flag("--json", json, "print the diagnostics as JSON to standard output");
  own.flag("--dump", dump, "print the evaluated scene as JSON to standard output (docs/dump.md)");
  add_scene_options(own, options);
  refuse_render_options(own);
  own.switches({Topic::scene, Topic::size, Topic::animation, Topic::messages});
  const std::vector<std::string> files = apply_words(options, own.parse(arguments));
  if (files.size() > 1) throw OptionError(fmt::format("one scene at a time: '{}' and '{}'", files[0], files[1]));
  if (!files.empty()) options.input_file = files[0];
  if (options.input_file.empty() && !options.stdin_name.empty()) options.input_file = "-";
  if (options.input_file.empty()) throw OptionError("no scene: verisim check SCENE [switches]");
  validate(options);
  const SceneSource scene = open_scene(options);
  if (!scene.found()) throw std::runtime_error(fmt::format("cannot find the scene '{}'", options.input_file));

  Console console(options, Style::verisim);
  Interrupt interrupt(options.max_seconds);
  const Job job{options, console, interrupt, scene, animation(options)};
  parser::ParseOptions parse = parse_options(job, job.animation.frame(0));
  std::vector<parser::Diagnostic> messages;
  if (json) parse.message = [&](const parser::Diagnostic& d) { messages.push_back(d); };
  // Taking a large scene apart takes as long as a good part of reading it, and the process ends anyway: it is kept
  // until then.
  static std::unique_ptr<parser::ParseResult>& kept = *new std::unique_ptr<parser::ParseResult>;
  kept = std::make_unique<parser::ParseResult>(parse_scene(job, parse));
  const parser::ParseResult& result = *kept;
  console.end_of_debug();
  if (interrupt.flag()) return kInterrupted;

  ExitStatus status = result.scene ? kOk : kSceneErrors;
  for (const parser::Diagnostic& error : result.errors)
    if (error.severity == parser::Severity::unsupported) status = kUnsupported;
  if (result.scene) {
    try {
      render::check_supported(*result.scene, render_options(job, {0, options.width - 1, 0, options.height - 1}));
    } catch (const render::Unsupported& missing) {
      parser::Diagnostic d;
      d.severity = parser::Severity::unsupported;
      d.file = missing.place.file ? *missing.place.file : scene.path.string();
      d.line = missing.place.line;
      d.column = missing.place.column;
      d.message = missing.what();
      parse.message(d);
      status = kUnsupported;
    }
  }
  if (dump && result.scene) {
    std::puts(SceneDump().scene(*result.scene).dump(1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return status;
  }
  if (json) {
    nlohmann::json report{{"scene", scene.path.string()},
                          {"errors", result.errors.size()},
                          {"warnings", result.warnings},
                          {"status", static_cast<int>(status)}};
    report["diagnostics"] = nlohmann::json::array();
    for (const parser::Diagnostic& d : messages) report["diagnostics"].push_back(as_json(d));
    std::puts(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    console.line(Stream::statistic, fmt::format("{}: {}, {} warning{}", scene.path.string(),
                                                status == kOk            ? "no errors"
                                                : status == kUnsupported ? "not supported"
                                                                         : "errors",
                                                result.warnings, result.warnings == 1 ? "" : "s"));
  }
  return status;
}

}  // namespace verisim::cli
