// What a folder of stored pictures says about them (baseline.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace verisim::compare {

// Names of the scenes that have a stored picture.
std::vector<std::string> stored_scenes(const std::filesystem::path& baseline);
// How a picture was made, for a message: "; it was stored by 1.0 with +W320 +H240 -A". Empty when that is not known.
std::string stored_call(const std::filesystem::path& baseline, const std::string& scene);

}  // namespace verisim::compare
