// The `--` options of a subcommand (CLI11 behind a small seam), separated from the words in POV-Ray's style that stand
// among them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/settings/options.h"

namespace verisim::cli {

// --help was given: the text to print.
struct HelpWanted {
  std::string text;
};

class OwnOptions {
 public:
  OwnOptions(const std::string& command, const std::string& description);
  ~OwnOptions();

  // Names as in "--stats"; the variables must outlive parse().
  void flag(const std::string& name, bool& value, const std::string& help);
  void value(const std::string& name, std::string& value, const std::string& help);
  void value(const std::string& name, int& value, const std::string& help);
  void value(const std::string& name, std::uint64_t& value, const std::string& help);
  void value(const std::string& name, double& value, const std::string& help);
  void values(const std::string& name, std::vector<std::string>& value, const std::string& help);  // may be given again
  void paths(const std::string& name, std::vector<std::filesystem::path>& value, const std::string& help);
  // An option of the plan that this version does not have: refused by name.
  void refused(const std::string& name, bool takes_value, const std::string& reason);

  // Returns the words that are not `--` options, in order; "--" ends the options. Throws OptionError or HelpWanted.
  std::vector<std::string> parse(const std::vector<std::string>& arguments);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The options every command that reads a scene has.
void add_scene_options(OwnOptions& own, Options& options);
// And those of commands that render it.
void add_render_options(OwnOptions& own, Options& options);

}  // namespace verisim::cli
