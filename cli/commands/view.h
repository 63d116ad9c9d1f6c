// What `verisim view` is asked for.
#pragma once

#include <string>
#include <vector>

#include "cli/settings/options.h"

namespace verisim::cli {

struct ViewSettings {
  Options options;  // input_file is the scene
  bool open = true;
  int port = 0;
  std::string token;
};

// Throws OptionError, or HelpWanted.
ViewSettings view_settings(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
