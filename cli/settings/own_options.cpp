#include "cli/settings/own_options.h"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/settings/text.h"

namespace verisim::cli {

struct OwnOptions::Impl {
  CLI::App app;
  std::vector<std::string> names{"--help"};
  struct Refusal {
    bool takes_value = false;
    std::string reason;
  };
  std::map<std::string, Refusal> refused;

  Impl(const std::string& command, const std::string& description) : app(description, "verisim " + command) {
    app.set_help_flag("--help", "Print this help and exit");
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }
  template <class T>
  void add(const std::string& name, T& value, const std::string& help) {
    names.push_back(name);
    app.add_option(name, value, help);
  }
};

OwnOptions::OwnOptions(const std::string& command, const std::string& description)
    : impl_(std::make_unique<Impl>(command, description)) {}
OwnOptions::~OwnOptions() = default;

void OwnOptions::flag(const std::string& name, bool& value, const std::string& help) {
  impl_->names.push_back(name);
  impl_->app.add_flag(name, value, help);
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
  impl_->names.push_back(name);
  impl_->app.add_option(name, value, help)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->expected(1);
}
void OwnOptions::paths(const std::string& name, std::vector<std::filesystem::path>& value, const std::string& help) {
  impl_->names.push_back(name);
  const auto append = [&value](const std::string& text) { value.emplace_back(text); };
  impl_->app.add_option_function<std::string>(name, append, help)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->expected(1)
      ->trigger_on_parse();
}
void OwnOptions::refused(const std::string& name, bool takes_value, const std::string& reason) {
  impl_->refused[name] = {takes_value, reason};
}

std::vector<std::string> OwnOptions::parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> words, own;
  bool ended = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (ended || !argument.starts_with("--")) {
      words.push_back(argument);
      continue;
    }
    if (argument == "--") {
      ended = true;
      continue;
    }
    const std::string name = argument.substr(0, argument.find('='));
    if (const auto refusal = impl_->refused.find(name); refusal != impl_->refused.end())
      throw OptionError(fmt::format("{} is not supported yet: {}", name, refusal->second.reason));
    const CLI::Option* option = impl_->app.get_option_no_throw(name);
    if (!option) {
      const std::string advice = nearest(name, {impl_->names.begin(), impl_->names.end()});
      throw OptionError(
          fmt::format("unknown option '{}'{}", name, advice.empty() ? "" : "; did you mean " + advice + "?"));
    }
    own.push_back(argument);
    if (name.size() == argument.size() && option->get_items_expected_max() > 0) {
      if (i + 1 == arguments.size()) throw OptionError(fmt::format("{} needs a value", name));
      own.back() += "=" + arguments[++i];
    }
  }
  try {
    std::reverse(own.begin(), own.end());  // CLI11 takes them from the back
    impl_->app.parse(own);
  } catch (const CLI::CallForHelp&) {
    throw HelpWanted{impl_->app.help()};
  } catch (const CLI::ParseError& error) {
    throw OptionError(error.what());
  }
  return words;
}

void add_scene_options(OwnOptions& own, Options& options) {
  own.paths("--allow-read", options.allow_read,
            "Let the scene read only below this path (may be given again); without it it may read everything");
  own.paths("--allow-write", options.allow_write,
            "Let the scene write (#fopen) below this path, too (may be given again); without it only below the current "
            "folder and the scene's");
  own.value("--max-seconds", options.max_seconds, "Give up after this time; 0: no limit");
  own.value("--max-steps", options.limits.max_steps,
            "Limit of executed tokens of the scene (default 10^11, some ten minutes of an endless loop); 0: no limit");
  own.value("--max-tokens", options.limits.max_tokens, "Limit of tokens in all files together");
  own.value("--max-file-bytes", options.limits.max_file_bytes, "Limit of one source file");
  own.value("--max-memory", options.limits.max_memory_bytes, "Limit of the memory that parsing takes, in bytes");
  own.value("--max-depth", options.limits.max_depth, "Limit of nested blocks, parentheses and calls");
  own.flag("--color", options.color, "Colour messages also when they do not go to a terminal");
}

void add_render_options(OwnOptions& own, Options& options) {
  add_scene_options(own, options);
  own.flag("--replay", options.replay, "Render serially with POV-Ray's random streams: equals `povray +WT1`");
  own.value("--seed", options.seed, "Another sequence of random numbers");
  own.value("--max-pixels", options.max_pixels, "Limit of the size of a picture");
  own.value("--stats", options.stats_file, "Write statistics as JSON to this file");
  own.value("--output", options.exact_output,
            "The picture's file, named as it is; the type by its extension unless +F says otherwise");
  own.flag("--allow-shell", options.allow_shell, "Run the commands of Pre_Scene_Command and its like");
  own.value("--sampler", options.sampler,
            "How pixels are anti-aliased: povray (+AM1, +AM2), or adaptive: low-discrepancy samples until the error is "
            "below a twentieth of +A's threshold");
  own.value("--integrator", options.integrator,
            "`povray`: POV-Ray's algorithms (default); `path`: unbiased path tracing, not POV-Ray's look");
  own.value("--path-samples", options.path_samples, "Paths a pixel of --integrator path (default 64)");
  own.value("--path-bounces", options.path_bounces, "No path is longer (default 64)");
  own.value("--layers", options.layers,
            "What the OpenEXR file holds: beauty, depth, normal, albedo, id, separated by commas, or all");
}

}  // namespace verisim::cli
