// INI files and the words of a command line, read in POV-Ray's way onto Options (spec 02 sections 9.2 to 9.4).
#pragma once

#include <filesystem>
#include <string_view>

#include "cli/settings/options.h"

namespace verisim::cli {

// One argument: switches, Key=Value, an INI file (name[section]), a .pov file or a folder ending in '/'; several may
// stand in it, parted by spaces. Throws OptionError.
void apply_argument(Options& options, std::string_view argument);

// Reads an INI file found as POV-Ray finds it (the current folder, then the library paths so far). `name` may end in
// [section]. Throws OptionError when it is missing or has a line that cannot be understood.
void apply_ini_file(Options& options, std::string_view name);

// The text of an INI file; `source` stands in messages.
void apply_ini_text(Options& options, std::string_view text, std::string_view section, std::string_view source);

}  // namespace verisim::cli
