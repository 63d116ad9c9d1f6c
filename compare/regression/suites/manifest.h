// Manifests of scenes (verisim.toml, described in docs/comparison.md), and scene files of a folder.
#pragma once

#include <filesystem>
#include <vector>

#include "compare/compare.h"

namespace verisim::compare {

bool is_scene(const std::filesystem::path& path);

// Sorted, so that a run's order does not depend on the file system; hidden folders are passed over.
std::vector<std::filesystem::directory_entry> entries(const std::filesystem::path& folder);

// The scenes of a manifest; what it does not say is as in `defaults`. Throws std::runtime_error with file and line.
std::vector<SceneRequest> read_manifest(const std::filesystem::path& file, const SuiteDefaults& defaults);

}  // namespace verisim::compare
