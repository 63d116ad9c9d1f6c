// The settings of a topic as a section of the help: every INI keyword with the switches that set it.
#pragma once

#include "cli/help/help.h"
#include "cli/settings/reading/switches.h"

namespace verisim::cli {

HelpSection topic_help(Topic topic);

// What to write in the place of `--width` or `--width=640`: "+W640 or Width=640", for names of settings in GNU style
// and for the usual names of other renderers; empty when it is neither.
std::string povray_spelling(std::string_view option, std::string_view value);

}  // namespace verisim::cli
