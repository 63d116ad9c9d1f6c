// Landlock (Linux 5.13): this thread, and those that it starts, open only what the policy names. Needs no privilege.
#pragma once

#include "cli/sandbox/policy.h"

namespace verisim::cli {

// The version of the kernel's interface; 0: it has none, or it is switched off, or a container refuses it.
int landlock_version();

// Throws std::runtime_error when the kernel refuses. Paths that are not there are left out.
void restrict_files(const Policy& policy);

}  // namespace verisim::cli
