#include "cli/settings/reading/own_options.h"

#include <algorithm>
#include <array>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/settings/process_limits.h"
#include "cli/settings/reading/scene_words.h"
#include "cli/settings/reading/switch_help.h"
#include "cli/settings/text.h"

namespace verisim::cli {

struct OwnOptions::Impl {
  CLI::App app;
  CommandHelp help;
  std::vector<std::string> names{"--help"};
  std::map<std::string, std::string> refused;               // by name: why
  std::map<std::string, std::string> alone;                 // by name: the value of who gives none
  std::map<std::string, std::vector<std::string>> presets;  // what an option stands for
  std::string preset_given;

  Impl(const std::string& command, const std::string& description) : app(description, "verisim " + command) {
    app.set_help_flag();  // the help is not CLI11's
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    help.name = command;
    help.description = description;
  }
  // Notes the option for the help; returns its name.
  std::string note(const std::string& written, const std::string& meaning) {
    if (help.sections.empty()) help.sections.push_back({"Options", {}});
    help.sections.back().entries.push_back({{written}, meaning});
    names.push_back(bare_option(written));
    // "--name[=VALUE]": by itself it stands for that value.
    if (const std::size_t value = written.find("[="); value != std::string::npos)
      alone[names.back()] = written.substr(value + 2, written.size() - value - 3);
    return names.back();
  }
  template <class T>
  void add(const std::string& written, T& value, const std::string& meaning) {
    app.add_option(note(written, meaning), value);
  }
  std::string advice(const std::string& name, const std::string& value) const;
};

// What to do about an option that this command does not have.
std::string OwnOptions::Impl::advice(const std::string& name, const std::string& value) const {
  if (const std::string povray = povray_spelling(name, value); !povray.empty())
    return "; that is a setting of POV-Ray's: write " + povray;
  if (const std::string near = nearest(name, {names.begin(), names.end()}); !near.empty())
    return "; did you mean " + near + "?";
  return fmt::format("; `verisim {}--help` lists them", help.name.empty() ? "" : help.name + " ");
}

OwnOptions::OwnOptions(const std::string& command, const std::string& description)
    : impl_(std::make_unique<Impl>(command, description)) {}
OwnOptions::~OwnOptions() = default;

OwnOptions& OwnOptions::synopsis(const std::string& text) { return impl_->help.synopsis = text, *this; }
OwnOptions& OwnOptions::summary(const std::string& text) { return impl_->help.summary = text, *this; }
OwnOptions& OwnOptions::example(const std::string& call, const std::string& meaning) {
  impl_->help.examples.push_back({call, meaning});
  return *this;
}
OwnOptions& OwnOptions::switches(std::initializer_list<Topic> topics) {
  for (const Topic topic : topics) impl_->help.sections.push_back(topic_help(topic));
  return *this;
}
OwnOptions& OwnOptions::section(const std::string& title) {
  impl_->help.sections.push_back({title, {}});
  return *this;
}

void OwnOptions::flag(const std::string& name, bool& value, const std::string& help) {
  impl_->app.add_flag(impl_->note(name, help), value);
}
void OwnOptions::value(const std::string& name, std::string& value, const std::string& help) {
  impl_->add(name, value, help);
}
void OwnOptions::value(const std::string& name, int& value, const std::string& help) { impl_->add(name, value, help); }
void OwnOptions::value(const std::string& name, std::uint64_t& value, const std::string& help) {
  impl_->add(name, value, help);
}
void OwnOptions::value(const std::string& name, double& value, const std::string& help) {
  impl_->add(name, value, help);
}
void OwnOptions::values(const std::string& name, std::vector<std::string>& value, const std::string& help) {
  impl_->app.add_option(impl_->note(name, help), value)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->expected(1);
}
void OwnOptions::paths(const std::string& name, std::vector<std::filesystem::path>& value, const std::string& help) {
  const auto append = [&value](const std::string& text) { value.emplace_back(text); };
  impl_->app.add_option_function<std::string>(impl_->note(name, help), append)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->expected(1)
      ->trigger_on_parse();
}
void OwnOptions::preset(const std::string& name, const std::string& value, std::span<const char* const> options,
                        const std::string& help) {
  const std::string noted = impl_->note(name + " " + value, help);
  impl_->app.add_option(noted, impl_->preset_given)->check(CLI::IsMember({value}));
  impl_->presets[noted] = {options.begin(), options.end()};
}
void OwnOptions::refused(const std::string& name, const std::string& reason) { impl_->refused[name] = reason; }
void OwnOptions::refuse_others_of(const OwnOptions& other, const std::string& reason) {
  for (const std::string& name : other.impl_->names)
    if (std::find(impl_->names.begin(), impl_->names.end(), name) == impl_->names.end()) refused(name, reason);
}

std::vector<std::string> OwnOptions::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> words, own;
  bool ended = false;
  std::error_code ignored;
  if (arguments.size() == 1 && arguments[0] == "help" && !std::filesystem::exists("help", ignored) &&
      !std::filesystem::exists("help.pov", ignored))
    throw HelpWanted{impl_->help};
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (!ended && (argument == "-h" || argument == "-?" || argument == "-help" || argument == "--help"))
      throw HelpWanted{impl_->help};
    if (ended || !argument.starts_with("--")) {
      words.push_back(argument);
      continue;
    }
    if (argument == "--") {
      ended = true;
      continue;
    }
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    if (const auto refusal = impl_->refused.find(name); refusal != impl_->refused.end())
      throw OptionError(fmt::format("{} does nothing here: {}", name, refusal->second));
    const CLI::Option* option = impl_->app.get_option_no_throw(name);
    if (!option) {
      const std::string value = equals != std::string::npos ? argument.substr(equals + 1)
                                : i + 1 < arguments.size() && !is_setting_word(arguments[i + 1]) ? arguments[i + 1]
                                                                                                 : "";
      throw OptionError(fmt::format("unknown option '{}'{}", name, impl_->advice(name, value)));
    }
    own.push_back(argument);
    if (const auto alone = impl_->alone.find(name); alone != impl_->alone.end()) {
      if (equals == std::string::npos) own.back() += "=" + alone->second;
    } else if (name.size() == argument.size() && option->get_items_expected_max() > 0) {
      if (i + 1 == arguments.size()) throw OptionError(fmt::format("{} needs a value", name));
      own.back() += "=" + arguments[++i];
    }
  }
  for (const auto& [name, meant] : impl_->presets)
    if (std::any_of(own.begin(), own.end(),
                    [&, name = name](const std::string& o) { return o.starts_with(name + "="); }))
      for (const std::string& option : meant)  // first of all, so that what is given counts
        if (impl_->app.get_option_no_throw(option.substr(0, option.find('=')))) own.insert(own.begin(), option);
  try {
    std::reverse(own.begin(), own.end());  // CLI11 takes them from the back
    impl_->app.parse(own);
  } catch (const CLI::ParseError& error) {
    throw OptionError(error.what());
  }
  return words;
}

// What a server can offer to the world; each may be changed by its own option.
constexpr std::array kStrangers{"--max-seconds=60",       "--max-cpu-seconds=240", "--max-memory=1073741824",
                                "--max-steps=1000000000", "--max-tokens=16777216", "--max-file-bytes=268435456",
                                "--max-depth=200",        "--max-pixels=16777216", "--max-output-bytes=16777216",
                                "--max-rays=10000000000"};

void add_scene_options(OwnOptions& own, Options& options) {
  own.section("Input");
  own.values("--library FOLDER", options.library_paths,
             "look for include files, images and fonts there, too (may be given again): +L for scripts, without its "
             "rules for quotes");
  own.value("--stdin-name FILE", options.stdin_name,
            "the name of a scene that comes from - (an editor's unsaved text): for messages, and for include files "
            "beside it");
  own.section("What the scene may do");
  own.paths("--allow-read PATH", options.allow_read,
            "let the scene read only below this path (may be given again); without it it may read everything");
  own.paths("--allow-write PATH", options.allow_write,
            "let the scene write (#fopen) below this path, too (may be given again); without it only below the current "
            "folder and the scene's");
  own.value(
      "--sandbox[=strict]", process_limits.sandbox,
      "let the kernel (Landlock, seccomp) keep the scene within its folder, the include paths, fonts, the outputs "
      "named here, --allow-read and --allow-write: no other file, no network, no processes. strict: "
      "what the kernel lacks is an error; best-effort: it is a warning; off");
  own.value("--max-seconds X", options.max_seconds, "give up after this time by the clock; 0: no limit (default)");
  own.value("--max-cpu-seconds X", options.max_cpu_seconds,
            "give up when all threads together have taken this time; 0: no limit (default)");
  own.preset("--limits", "strangers", kStrangers,
             "limits for scenes of strangers: a minute, four of all threads, 1 GiB, 2^24 pixels, 10^10 rays, 16 MiB of "
             "text and more; the options "
             "here change single ones");
  own.value("--max-steps N", options.limits.max_steps,
            "executed tokens of the scene (default 10^11, some ten minutes of an endless loop); 0: no limit");
  own.value("--max-tokens N", options.limits.max_tokens, "tokens in all files together");
  own.value("--max-file-bytes N", options.limits.max_file_bytes, "bytes of one source file");
  own.value("--max-memory N", options.limits.max_memory_bytes, "bytes of memory that the whole run may take");
  own.value("--max-depth N", options.limits.max_depth, "nested blocks, parentheses and calls");
  own.value("--max-pixels N", options.max_pixels, "pixels of a picture");
  own.value("--max-output-bytes N", process_limits.max_output_bytes,
            "bytes that the scene may write and say: #write, #debug, #warning and all warnings, 4096 for each file; 0: "
            "no limit (default)");
  own.value("--max-rays N", process_limits.max_rays, "rays of a picture; 0: no limit (default)");
  own.section("Messages");
  own.flag("--color", options.color, "colour messages also when they do not go to a terminal");
}

void add_pixel_options(OwnOptions& own, Options& options) {
  own.section("Random numbers");
  own.flag("--replay", options.replay, "render serially with POV-Ray's random streams: equals `povray +WT1`");
  own.value("--seed N", options.seed, "another sequence of random numbers");
  add_scene_options(own, options);
}

void add_render_options(OwnOptions& own, Options& options) {
  own.section("Files");
  own.value("--output FILE", options.exact_output,
            "the picture's file, named as it is, or - for standard output; the type by its extension unless +F says "
            "otherwise");
  own.value("--layers LIST", options.layers,
            "what the OpenEXR file holds: beauty, depth, normal, albedo, id, separated by commas, or all");
  own.value("--part K/N", options.part,
            "render part K of N of the picture, for verisim merge; or prepass: what comes before the picture (photons, "
            "radiosity) and is the same for all parts; --output names the file");
  own.value("--prepass FILE", options.prepass_file, "read what --part prepass made, instead of making it again");
  own.flag("--stamp", options.stamp,
           "write the date and the time that the render took into the picture's file (the date of SOURCE_DATE_EPOCH "
           "alone, where that is set); without it the same picture is always the same file");
  own.value("--stats FILE", options.stats_file, "write statistics as JSON to this file");
  own.section("Rendering");
  own.value("--sampler NAME", options.sampler,
            "how pixels are anti-aliased: povray (+AM1, +AM2; default), or adaptive: low-discrepancy samples until the "
            "error is below a twentieth of +A's threshold");
  own.value("--integrator NAME", options.integrator,
            "povray: POV-Ray's algorithms (default); path: unbiased path tracing, not POV-Ray's look");
  own.value("--path-samples N", options.path_samples, "paths a pixel of --integrator path (64)");
  own.value("--path-bounces N", options.path_bounces, "no path of --integrator path is longer (64)");
  own.value("--progress STYLE", options.progress,
            "how far it is, on standard error: bar (default on a terminal), json or openjd (lines for programs), none");
  own.flag("--allow-shell", options.allow_shell, "run the commands of Pre_Scene_Command and its like");
  add_pixel_options(own, options);
}

void refuse_render_options(OwnOptions& own) {
  Options unused;
  OwnOptions render("render", "");
  add_render_options(render, unused);
  own.refuse_others_of(render, "it is an option of `verisim render`, and this command draws no picture");
}

}  // namespace verisim::cli
