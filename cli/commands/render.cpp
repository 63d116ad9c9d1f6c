// `verisim render`, and the call in POV-Ray's style: all frames of one scene, with shell-outs and statistics around
// them.

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/settings/reading/configuration.h"
#include "cli/frame/frame.h"
#include "cli/settings/frame_list.h"
#include "cli/settings/reading/ini.h"
#include "cli/settings/output_name.h"
#include "cli/settings/reading/own_options.h"
#include "cli/sandbox/sandbox.h"
#include "cli/settings/reading/scene_words.h"
#include "cli/console/shellout.h"
#include "cli/frame/statistics.h"
#include "tracer/base/output_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// What the frames came to.
struct Outcome {
  ExitStatus status = kOk;
  bool user_abort = false;
  std::vector<FrameReport> frames;
};

class Sequence {
 public:
  // `frames`: numbers, from 0, of those that are rendered.
  Sequence(const Job& job, std::vector<std::size_t> frames) : job_(job), frames_(std::move(frames)) {}

  // Spec 02 section 11: what the letter of a return rule does depends on where it fires.
  Outcome run() {
    switch (shell(job_.options.pre_scene, job_.animation.frame(0))) {
      case 'S':
        return end_scene();
      case 'A':
      case 'Q':
        return std::move(outcome_);
      case 'U':
        return user_abort();
      case 'F':
        return fatal();
      default:
        break;
    }
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const Frame frame = job_.animation.frame(frames_[i]);
      switch (shell(job_.options.pre_frame, frame)) {
        case 'S':
          continue;
        case 'A':
          return end_scene();
        case 'Q':
          return std::move(outcome_);
        case 'U':
          return user_abort();
        case 'F':
          return fatal();
        default:
          break;
      }
      announce(frame, i);
      job_.console.begin_frame(i, frame.number);
      outcome_.frames.push_back(render_frame(job_, frame));
      const FrameReport& report = outcome_.frames.back();
      if (report.status == kOk) job_.console.frame_done(report.output, report.skipped);
      summary(report);
      if (report.status != kOk) {
        outcome_.status = report.status;
        shell(report.status == kInterrupted ? job_.options.user_abort : job_.options.fatal_error, frame);
        return std::move(outcome_);
      }
      if (report.skipped) continue;
      switch (shell(job_.options.post_frame, frame)) {
        case 'S':
        case 'A':
        case 'Q':
          return std::move(outcome_);
        case 'U':
          return user_abort();
        case 'F':
          return fatal();
        default:
          break;
      }
    }
    return end_scene();
  }

 private:
  char shell(const ShellCommand& command, const Frame& frame) {
    if (command.command.empty()) return 'I';
    const OutputName name = output_name(job_.options, job_.scene.path, job_.animation, frame);
    return shell_out(command,
                     {name.path.string(), job_.scene.path.string(), frame.number, job_.options.width,
                      job_.options.height, frame.clock},
                     job_.options.allow_shell, job_.console);
  }
  Outcome end_scene() {
    shell(job_.options.post_scene, last_frame());
    return std::move(outcome_);
  }
  Outcome user_abort() {
    shell(job_.options.user_abort, last_frame());
    shell(job_.options.post_scene, last_frame());
    outcome_.status = kDifferent;
    outcome_.user_abort = true;
    return std::move(outcome_);
  }
  Outcome fatal() {
    shell(job_.options.fatal_error, last_frame());
    outcome_.status = kDifferent;
    return std::move(outcome_);
  }
  Frame last_frame() const {
    return job_.animation.frame(outcome_.frames.empty() ? 0 : frames_[outcome_.frames.size() - 1]);
  }

  void announce(const Frame& frame, std::size_t index) {
    if (job_.console.style() == Style::povray) {
      if (job_.animation.on)
        job_.console.always(fmt::format("\nRendering frame {} of {}\n", index + 1, frames_.size()));
      job_.console.line(Stream::render, option_text(job_, frame));
    } else if (job_.animation.on && job_.options.verbose) {
      job_.console.line(Stream::render,
                        fmt::format("frame {} of {}, clock {:g}", index + 1, frames_.size(), frame.clock));
    }
  }

  void summary(const FrameReport& report) {
    if (job_.console.style() == Style::povray || report.status != kOk || report.skipped || !job_.options.verbose)
      return;
    const std::string name = report.output.empty()
                                 ? job_.options.output_to_file ? "the picture to a stream" : "no file (-F)"
                                 : report.output.string();
    job_.console.line(Stream::statistic,
                      fmt::format("{} by {}: parsed in {:.2f} s, rendered in {:.2f} s, wrote {}", job_.options.width,
                                  job_.options.height, report.seconds_parse, report.seconds_render, name));
  }

  const Job& job_;
  std::vector<std::size_t> frames_;
  Outcome outcome_;
};

void create_ini(const Options& options) {
  std::string text = "; Settings as given to verisim\n";
  for (const auto& [key, value] : options.given)
    if (key != "Create_Ini")
      text += fmt::format("{}={}\n", key,
                          value.find_first_of(" ;#,") != std::string::npos && value.find('"') == std::string::npos
                              ? '"' + value + '"'
                              : value);
  write_text_file(options.create_ini, text);
}

// Numbers, from 0, of the frames that --frames names (all, if it is not given); what it names past their end is
// nothing.
std::vector<std::size_t> chosen_frames(const Options& options, const std::string& list) {
  const Animation all = animation(options);
  if (!all.on && !list.empty() && !options.final_frame)
    throw OptionError("--frames is for animations: say how many frames there are (+KFFn)");
  const std::vector<FrameRange> ranges = list.empty() || !all.on ? std::vector<FrameRange>{} : frame_list(list);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < all.count(); ++i) {
    const int number = all.frame(i).number;
    if (ranges.empty() ||
        std::any_of(ranges.begin(), ranges.end(), [number](const FrameRange& r) { return r.holds(number); }))
      chosen.push_back(i);
  }
  return chosen;
}

// From finished options to the last frame.
Outcome render_all(const Options& options, Console& console, const SceneSource& scene, const std::string& frame_list) {
  if (!options.create_ini.empty()) create_ini(options);
  Interrupt interrupt(watch(options, console));
  const std::vector<std::size_t> frames = chosen_frames(options, frame_list);
  SharedScene shared;
  const Job job{options, console, interrupt, scene, animation(options), &shared};
  const fs::path picture = output_name(options, scene.path, job.animation, job.animation.frame(0)).path;
  console.open_files(picture.parent_path(), options.append_files);
  for (const std::string& note : options.notes)
    if (options.verbose || console.style() == Style::verisim) console.line(Stream::warning, wrapped("Note: " + note));
  console.begin_progress(scene.path, frames.size());
  Outcome outcome = Sequence(job, frames).run();
  if (!options.stats_file.empty()) write_text_file(options.stats_file, statistics_json(job, outcome.frames));
  if (interrupt.signal() != 0) outcome.status = kInterrupted;
  console.end_of_call(outcome.status, outcome.frames.empty() ? "" : outcome.frames.back().message);
  return outcome;
}

}  // namespace

int command_render(const std::vector<std::string>& arguments) {
  Options options;
  std::string frames;
  OwnOptions own("render",
                 "Renders a scene. POV-Ray's switches (+W320 +A0.3), settings (Width=320) and INI files, also with a "
                 "section (quick.ini[small]), stand anywhere after the command. A switch begins with + or -; - turns "
                 "what is on or off off.");
  own.synopsis("SCENE [options] [switches]")
      .summary("render a scene")
      .example("verisim render scene.pov +W640 +H480 +A0.3 +Opicture.png", "640 by 480, anti-aliased")
      .example("verisim render scene.pov +KFF24 +Oframes/", "24 frames, clock from 0 to 1")
      .example("verisim render - --output - +FJ < scene.pov > picture.jpg", "in a pipe");
  own.refused("--dump", "verisim check --dump prints the scene");
  own.section("Animation");
  own.value("--frames LIST", frames,
            "render only these frames of the animation, as in 1-10 or 1-9:2,20; what lies past its end is left out");
  add_render_options(own, options);
  own.switches({Topic::scene, Topic::size, Topic::output, Topic::quality, Topic::speed, Topic::animation,
                Topic::messages, Topic::commands, Topic::ignored});
  const std::vector<std::string> files = apply_words(options, own.parse(arguments));
  if (files.size() > 1) throw OptionError(fmt::format("one scene at a time: '{}' and '{}'", files[0], files[1]));
  if (!files.empty()) options.input_file = files[0];
  if (options.input_file.empty()) throw OptionError("no scene: verisim render SCENE [switches]");
  choose_format(options);
  validate(options);
  chosen_frames(options, frames);  // a bad list is told before anything is read
  std::error_code ignored;
  const SceneSource scene = open_scene(options);
  Console console(options, Style::verisim);
  if (!scene.found()) {
    console.line(Stream::fatal, fmt::format("verisim: error: {} '{}'",
                                            fs::is_directory(options.input_file, ignored) ? "the scene is a folder:"
                                                                                          : "cannot find the scene",
                                            options.input_file));
    return kInputOutput;
  }
  sandbox_render(options, scene);
  const Outcome outcome = render_all(options, console, scene, frames);
  if (outcome.status == kInterrupted) console.line(Stream::fatal, "verisim: interrupted; +C continues the picture");
  return outcome.status;
}

int povray_call(const std::vector<std::string>& arguments) {
  Options options;
  // All of a wrong call is said before anything is done (spec 02 section 9.3).
  const auto refuse = [&](const std::string& why) {
    std::string call = "verisim";
    for (const std::string& argument : arguments) call += " " + argument;
    std::fprintf(stderr, "\nProblem with option setting\n%s\nFailed to parse command-line option\n%s\n\n", call.c_str(),
                 why.c_str());
    return 1;
  };
  try {
    OwnOptions own("",
                   "Called as povray is called: switches (+W320), settings (Width=320), INI files, a .pov file; and "
                   "the options below.");
    own.synopsis("[switches] [options]").summary("render as povray does");
    add_render_options(own, options);
    own.switches({Topic::scene, Topic::size, Topic::output, Topic::quality, Topic::speed, Topic::animation,
                  Topic::messages, Topic::commands, Topic::ignored});
    const std::vector<std::string> words = own.parse(arguments);
    apply_configuration(options);
    for (const std::string& word : words) apply_argument(options, word);
    if (options.input_file.empty()) return refuse("No input file provided");
    if (!options.exact_output.empty()) choose_format(options);
    validate(options);
    (void)animation(options);
  } catch (const OptionError& error) {
    return refuse(error.what());
  }
  Console console(options, Style::povray);
  console.always(banner());
  const SceneSource scene = open_scene(options);
  if (!scene.found()) {
    std::error_code ignored;
    const bool folder = fs::is_directory(options.input_file, ignored);
    console.line(Stream::fatal, wrapped(fmt::format("{} file '{}' (even after trying to append file type extension).",
                                                    folder ? "Is a folder:" : "Could not find", options.input_file)));
    console.line(Stream::fatal, "Parse Error: Cannot open input file.");
    console.always("Fatal error in parser: Cannot parse input.\nRender failed");
    return 1;
  }
  try {
    sandbox_render(options, scene);
    const Outcome outcome = render_all(options, console, scene, "");
    if (outcome.status == kInterrupted) {
      console.always("Fatal error in renderer: Frontend halted render.\nRender cancelled by user\n");
      return 2;
    }
    console.always(outcome.status == kOk ? "POV-Ray finished\n" : "Render failed\n");
    return outcome.status == kOk ? 0 : 1;
  } catch (const std::exception& error) {
    console.always(fmt::format("Fatal error: {}\nRender failed\n", error.what()));
    return 1;
  }
}

}  // namespace verisim::cli
