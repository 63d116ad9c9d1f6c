// What the live picture is held against: POV-Ray's picture of the scene, or a stored one.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "cli/settings/options.h"
#include "compare/compare.h"

namespace verisim::cli {

class Reference {
 public:
  // `words`: the settings as they were given, for POV-Ray. `stored`: a picture file; empty: none.
  Reference(std::filesystem::path scene, const Options& options, std::vector<std::string> words,
            std::filesystem::path stored);
  bool has_stored() const { return !stored_.empty(); }

  // Red, green and blue of 8 bits, row by row. POV-Ray renders, or its picture of the same files comes from the cache.
  // Throws std::runtime_error: what is wrong, in words.
  std::string povray(const std::vector<std::filesystem::path>& files_read, double clock);
  std::string stored();
  // LDR-FLIP of a picture against the one that was asked for last: an error in 0..1 for each pixel, as float32.
  std::string flip(const compare::Picture& test);

 private:
  std::string keep(compare::Picture picture);

  const std::filesystem::path scene_, stored_;
  const Options options_;
  const std::vector<std::string> words_;
  std::mutex mutex_;
  compare::Picture last_;
};

}  // namespace verisim::cli
