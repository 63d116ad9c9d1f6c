// Corrections that diagnostics bring with them, made in the files: `verisim check --fix`.
#pragma once

#include <vector>

#include "cli/console/console.h"
#include "parser/source/diagnostic.h"

namespace verisim::cli {

// Makes each correction once, files whole or not at all, and says what was done. False: there was none.
// Throws std::runtime_error when a file cannot be read or written.
bool apply_fixes(const std::vector<parser::Diagnostic>& diagnostics, Console& console);

}  // namespace verisim::cli
