// `--sandbox`: what is left to a command that reads a stranger's scene, enforced by the kernel (docs/robustness.md).
//
// Reading: the scene's folder, include paths, fonts, what --allow-read names, and the program's own libraries. Writing:
// in the folders of the outputs that the call names and what --allow-write names. Nothing else: no other file, no
// network, no processes, no devices. It cannot be left again.
#pragma once

#include <string>
#include <vector>

#include "cli/sandbox/policy.h"
#include "cli/settings/options.h"
#include "cli/settings/scene_source.h"

namespace verisim::cli {

// Whether --sandbox (process_limits) wants anything. Throws OptionError when its value is none.
bool wants_sandbox();

// What the scenes of a command may read and write. Relative paths count from the current folder.
Policy policy_of(const Options& options, const std::vector<SceneSource>& scenes);

// The scene's own rules, for errors that name what it asked for: the parser lets it read what the policy lets the
// process read, and write only below --allow-write.
void confine_scene(Options& options, const Policy& policy);

// Restricts this thread and those that it starts: call it before there are others. Does nothing without --sandbox.
// What the kernel lacks is an error (std::runtime_error), with best-effort a line on standard error.
void enter_sandbox(const Policy& policy);

// All of the above, for a command that renders one scene.
void sandbox_render(Options& options, const SceneSource& scene);

}  // namespace verisim::cli
