#include "cli/program.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/reading/scene_words.h"
#include "cli/settings/text.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::cli {
namespace {

void print_usage(std::FILE* where) { std::fputs(help_text(program_help()).c_str(), where); }

// --version and its like count only as exact words (spec 02 section 9.1).
bool is_one_of(const std::string& word, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (word == name) return true;
  return false;
}

int run_command(const Command& command, const std::vector<std::string>& arguments) {
  try {
    return command.run(arguments);
  } catch (const HelpWanted& wanted) {
    std::fputs(help_text(wanted.help).c_str(), stdout);
    return kOk;
  } catch (const OptionError& error) {
    std::fprintf(stderr, "verisim %s: %s\n", std::string(command.name).c_str(), error.what());
    return kUsage;
  } catch (const std::bad_alloc&) {
    std::fputs("verisim: error: there is not enough memory, or --max-memory does not allow it\n", stderr);
    return kInputOutput;
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
      const bool json = std::find(rest.begin(), rest.end(), "--json") != rest.end();
      std::fputs(version_text(json).c_str(), as_povray ? stderr : stdout);
      return kOk;
    }
    if (is_one_of(word, {"--benchmark", "-benchmark"})) {
      std::fputs("verisim has no built-in benchmark scene; `verisim bench SCENE...` measures scenes of yours\n",
                 stderr);
      return as_povray ? 1 : kUsage;
    }
  }
  if (const std::string wrong = simd::wrong_instruction_set(); !wrong.empty()) {
    std::fprintf(stderr, "verisim: %s\n", wrong.c_str());
    return as_povray ? 1 : kUsage;
  }
  if (!as_povray && !rest.empty())
    for (const Command& command : commands())
      if (rest[0] == command.name) return run_command(command, {rest.begin() + 1, rest.end()});
  if (!as_povray && !rest.empty() && rest[0] == "help")
    return run_command({"help", command_help}, {rest.begin() + 1, rest.end()});
  if (rest.empty() && !as_povray) {
    print_usage(stderr);
    return kUsage;
  }
  // A first word that is nothing POV-Ray would take is a slip in a subcommand's name.
  if (!as_povray && !is_setting_word(rest[0]) && !rest[0].starts_with("--") && rest[0].find('.') == std::string::npos) {
    std::error_code ignored;
    if (!std::filesystem::exists(rest[0] + ".ini", ignored) && !std::filesystem::exists(rest[0] + ".INI", ignored)) {
      std::vector<std::string_view> names;
      for (const Command& command : commands()) names.push_back(command.name);
      const std::string advice = nearest(rest[0], names);
      std::fprintf(stderr, "verisim: unknown command '%s'%s\n", rest[0].c_str(),
                   advice.empty() ? "" : ("; did you mean " + advice + "?").c_str());
      return kUsage;
    }
  }
  try {
    return povray_call(rest);
  } catch (const HelpWanted& wanted) {
    // Called as povray it tells what povray is asked with; otherwise what there is besides.
    std::fputs(help_text(as_povray ? wanted.help : program_help()).c_str(), as_povray ? stderr : stdout);
    return kOk;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verisim: %s\n", error.what());
    return 1;
  }
}

}  // namespace verisim::cli
