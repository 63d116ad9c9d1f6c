// How a verisim program is called for a scene.
#pragma once

#include "compare/compare.h"
#include "compare/oracle/process.h"

namespace verisim::compare {

// `program COMMAND SCENE +W +H [switches] [+WT] [+L...] [--replay] [--seed] --allow-write FOLDER` in the request's
// folder.
ProcessRequest program_call(const std::filesystem::path& program, const std::string& command,
                            const NativeRequest& request);

}  // namespace verisim::compare
