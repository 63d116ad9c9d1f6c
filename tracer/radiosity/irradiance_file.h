// Radiosity samples as a text file in POV-Ray's format (spec 07 2.12): one line a sample, fields separated by tabs.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "tracer/radiosity/irradiance_cache.h"

namespace verisim::global {

// Adds to the end of an existing file when `append`. Throws std::runtime_error.
void save_samples(const std::filesystem::path& path, std::span<const IrradianceSample> samples, bool append);
// Lines of other kinds are skipped, as POV-Ray does; a sample line that is damaged, or values no render could give, are
// an error (std::runtime_error with the line's number). At most `most` samples.
std::vector<IrradianceSample> load_samples(const std::filesystem::path& path, std::size_t most);

}  // namespace verisim::global
