// `verisim lsp`: the language server.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <set>
#include <string_view>

#include "cli/settings/options.h"

namespace verisim::cli::lsp {

struct ServerSettings {
  std::filesystem::path program;     // this one, to render with
  Options options;                   // where include files are, limits
  double seconds = 10;               // a scene is read for so long at most
  int delay_ms = 40;                 // after the last change before it is read
  std::set<std::string_view> lints;  // that are shown as hints
  int in = STDIN_FILENO, out = STDOUT_FILENO;
};

// Serves one client, over standard input and output if nothing else is said, until it says goodbye or is gone. Returns
// the exit status of the protocol: 0 after `shutdown` and `exit`, else 1.
int serve(const ServerSettings& settings);

}  // namespace verisim::cli::lsp
