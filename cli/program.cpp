#include "cli/program.h"

#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/settings/own_options.h"
#include "cli/settings/scene_words.h"
#include "cli/settings/text.h"

namespace verisim::cli {
namespace {

struct Command {
  std::string_view name;
  int (*run)(const std::vector<std::string>&);
  std::string_view summary;
};

constexpr Command kCommands[] = {
    {"render", command_render, "SCENE [switches]         render a scene"},
    {"check", command_check, "SCENE [--json]            read a scene and report what is wrong with it"},
    {"compare", command_compare, "SCENE...|FOLDER         render with verisim and POV-Ray and compare every pixel"},
    {"explain", command_explain, "SCENE X Y               how one pixel came to be"},
    {"diff", command_diff, "A B                        the same figures for two pictures"},
    {"bench", command_bench, "SCENE...                  time and memory of verisim and POV-Ray"},
};

void print_usage(std::FILE* where) {
  std::fputs("verisim " VERISIM_VERSION
             ": a native ray tracer for POV-Ray 3.7 scenes that proves itself against POV-Ray\n\n",
             where);
  for (const Command& command : kCommands)
    std::fprintf(where, "  verisim %.*s %.*s\n", static_cast<int>(command.name.size()), command.name.data(),
                 static_cast<int>(command.summary.size()), command.summary.data());
  std::fputs(
      "\n  verisim +Iscene.pov +Oout.png +W320 +H240 +A0.3     called as povray is called\n\n"
      "`verisim COMMAND --help` tells more. Exit status: 0 done, 1 a comparison failed, 2 bad usage, 3 errors in the "
      "scene, 4 not supported, 5 files;\n"
      "called as povray: 0, 1, or 2 after an interrupt.\n",
      where);
}

// --version and its like count only as exact words (spec 02 section 9.1).
bool is_one_of(const std::string& word, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (word == name) return true;
  return false;
}

int run_command(const Command& command, const std::vector<std::string>& arguments) {
  try {
    return command.run(arguments);
  } catch (const HelpWanted& help) {
    std::fputs(help.text.c_str(), stdout);
    return kOk;
  } catch (const OptionError& error) {
    std::fprintf(stderr, "verisim %s: %s\n", std::string(command.name).c_str(), error.what());
    return kUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verisim %s: %s\n", std::string(command.name).c_str(), error.what());
    return kInputOutput;
  }
}

}  // namespace

int run(const std::vector<std::string>& arguments) {
  const std::string called = arguments.empty() ? "verisim" : std::filesystem::path(arguments[0]).filename().string();
  const bool as_povray = called == "povray";
  std::vector<std::string> rest(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  for (const std::string& word : rest) {
    if (is_one_of(word, {"--version", "-version", "--V"})) {
      std::fputs("verisim " VERISIM_VERSION " (renders scenes of POV-Ray 3.7)\n", as_povray ? stderr : stdout);
      return kOk;
    }
    if (is_one_of(word, {"--benchmark", "-benchmark"})) {
      std::fputs("verisim has no built-in benchmark scene; `verisim bench SCENE...` measures scenes of yours\n",
                 stderr);
      return as_povray ? 1 : kUsage;
    }
  }
  if (!as_povray && !rest.empty())
    for (const Command& command : kCommands)
      if (rest[0] == command.name) return run_command(command, {rest.begin() + 1, rest.end()});
  for (const std::string& word : rest)
    if (is_one_of(word, {"--help", "-help", "-h", "-?"})) {
      print_usage(as_povray ? stderr : stdout);
      return kOk;
    }
  if (rest.empty() && !as_povray) {
    print_usage(stderr);
    return kUsage;
  }
  // A first word that is nothing POV-Ray would take is a slip in a subcommand's name.
  if (!as_povray && !is_setting_word(rest[0]) && !rest[0].starts_with("--") && rest[0].find('.') == std::string::npos) {
    std::error_code ignored;
    if (!std::filesystem::exists(rest[0] + ".ini", ignored) && !std::filesystem::exists(rest[0] + ".INI", ignored)) {
      std::vector<std::string_view> names;
      for (const Command& command : kCommands) names.push_back(command.name);
      const std::string advice = nearest(rest[0], names);
      std::fprintf(stderr, "verisim: unknown command '%s'%s\n", rest[0].c_str(),
                   advice.empty() ? "" : ("; did you mean " + advice + "?").c_str());
      return kUsage;
    }
  }
  try {
    return povray_call(rest);
  } catch (const HelpWanted&) {
    print_usage(as_povray ? stderr : stdout);
    return kOk;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verisim: %s\n", error.what());
    return 1;
  }
}

}  // namespace verisim::cli
