// The `--` options of a subcommand (CLI11 behind a small seam), separated from the words in POV-Ray's style that stand
// among them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/help/help.h"
#include "cli/settings/options.h"
#include "cli/settings/reading/switches.h"

namespace verisim::cli {

// --help or -h was given: what the command says of itself.
struct HelpWanted {
  CommandHelp help;
};

class OwnOptions {
 public:
  OwnOptions(const std::string& command, const std::string& description);
  ~OwnOptions();

  // For the help alone: what follows the name, the line in the list of commands, a call, POV-Ray's switches that do
  // something in this command, and the heading of the options that follow.
  OwnOptions& synopsis(const std::string& text);
  OwnOptions& summary(const std::string& text);
  OwnOptions& example(const std::string& call, const std::string& meaning);
  OwnOptions& switches(std::initializer_list<Topic> topics);
  OwnOptions& section(const std::string& title);

  // Names as in "--stats", or "--stats FILE" with what stands for the value in the help; the variables must outlive
  // parse().
  void flag(const std::string& name, bool& value, const std::string& help);
  void value(const std::string& name, std::string& value, const std::string& help);
  void value(const std::string& name, int& value, const std::string& help);
  void value(const std::string& name, std::uint64_t& value, const std::string& help);
  void value(const std::string& name, double& value, const std::string& help);
  void values(const std::string& name, std::vector<std::string>& value, const std::string& help);  // may be given again
  void paths(const std::string& name, std::vector<std::filesystem::path>& value, const std::string& help);
  // An option whose one value stands for several others (as words, "--name=value"); those that are given count more.
  void preset(const std::string& name, const std::string& value, std::span<const char* const> options,
              const std::string& help);
  // An option of another command that does nothing in this one: refused by name, with the reason.
  void refused(const std::string& name, const std::string& reason);
  // All options of another command that this one does not have.
  void refuse_others_of(const OwnOptions& other, const std::string& reason);

  // Returns the words that are not `--` options, in order; "--" ends the options. Throws OptionError or HelpWanted
  // (--help, -help, -h, -?).
  std::vector<std::string> parse(const std::vector<std::string>& arguments);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The options every command that reads a scene has.
void add_scene_options(OwnOptions& own, Options& options);
// Those of commands that trace single rays of it; includes the former.
void add_pixel_options(OwnOptions& own, Options& options);
// And those of commands that render it; includes the former.
void add_render_options(OwnOptions& own, Options& options);
// For a command that draws no picture: the options that only add_render_options has are refused with a reason.
void refuse_render_options(OwnOptions& own);

}  // namespace verisim::cli
