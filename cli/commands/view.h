// What `verisim view` is asked for.
#pragma once

#include <string>
#include <vector>

#include "cli/settings/options.h"

namespace verisim::cli {

struct ViewSettings {
  Options options;       // input_file is the scene
  bool lecture = false;  // its pages instead of a scene
  bool open = true;
  int port = 0;
  std::string token;
  std::string against;             // a picture to hold the live one against; empty: none
  std::vector<std::string> words;  // switches and settings as they were given
};

// Throws OptionError, or HelpWanted.
ViewSettings view_settings(const std::vector<std::string>& arguments);

// Of a page on the loopback interface. Throws OptionError.
void check_address(int port, const std::string& token);
// Hands over to the program verisim-view beside this one, which holds the web server (cli/view/), under a name that
// tells it what to serve. Throws std::runtime_error if it cannot be run.
[[noreturn]] void run_view_program(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace verisim::cli
